// SPDX-License-Identifier: MIT
// How fast the front end reads: megabytes (10^6 bytes) of scene text a second for each phase, what
// it keeps in memory, and a well-known parser on the same content in the same run.
//
//   bench_frontend [--megabytes N] [--seconds S] [--json] [--write FILE]
//
// Every measure is the best of at least three runs and of S seconds of runs (default 20 MB, 1 s),
// in processor time, so that other work on the machine disturbs it less.
// `--write` saves the scene for use with other tools.
#include <fmt/format.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/format/format.hpp"
#include "frontend/lex/tokens.hpp"
#include "frontend/parse/cst.hpp"
#include "tools/bench/scene_generator.hpp"

namespace {

using namespace cobble;
using Clock = std::chrono::steady_clock;

struct Measure {
    std::string name;
    double seconds = 0;
    double bytes_kept = -1;  ///< live heap after the run less before; -1: not measured
};

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

double live_bytes() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

double processor_seconds() {
    return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// The fastest of several runs. `run` returns what it built, which is timed without its
/// destruction and weighed once.
template <typename Run>
Measure measure(std::string name, double budget, Run run) {
    Measure result{std::move(name), std::numeric_limits<double>::infinity()};
    const Clock::time_point start = Clock::now();
    constexpr int kLeastRuns = 3;
    for (int i = 0; i < kLeastRuns || seconds_since(start) < budget; ++i) {
        const double before = live_bytes();
        const double begin = processor_seconds();
        const auto built = run();
        result.seconds = std::min(result.seconds, processor_seconds() - begin);
        result.bytes_kept = live_bytes() - before;
    }
    return result;
}

/// One run of a program from start to exit, its output thrown away; negative if it cannot run.
double process_seconds(const std::vector<std::string>& command) {
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const Clock::time_point begin = Clock::now();
    const pid_t child = fork();
    if (child == 0) {
        if (std::freopen("/dev/null", "w", stdout) != nullptr)
            execv(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) return -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? seconds_since(begin) : -1;
}

/// `cobble lint` of a scene of some ten kilobytes, the best of 50 runs.
double lint_seconds(const std::string& scene) {
    constexpr int kRuns = 50;
    std::string path = "/tmp/cobble-bench-XXXXXX.scene";
    const int file = mkstemps(path.data(), 6);
    if (file < 0) return -1;
    close(file);
    std::ofstream(path, std::ios::binary) << scene;
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kRuns && best > 0; ++i) {
        best = std::min(best, process_seconds({COBBLE_PROGRAM, "lint", path}));
    }
    unlink(path.c_str());
    return best;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Speed of the front end");
    double megabytes = 20;
    double budget = 1;
    bool as_json = false;
    std::string save;
    app.add_option("--megabytes", megabytes, "size of the scene");
    app.add_option("--seconds", budget, "time for each measure");
    app.add_flag("--json", as_json, "print JSON");
    app.add_option("--write", save, "save the scene");
    CLI11_PARSE(app, argc, argv);

    const bench::GeneratedScene generated =
        bench::generate_scene(static_cast<std::size_t>(megabytes * 1e6));
    const std::string& text = generated.scene;
    if (!save.empty()) std::ofstream(save, std::ios::binary) << text;

    const frontend::CheckedScene checked = frontend::check(source::SourceId{0}, text);
    const frontend::FormatResult formatted = frontend::format(text);
    if (!checked.diagnostics.empty() || formatted.refused || formatted.has_errors) {
        fmt::print(stderr, "the scene to measure with is not clean\n");
        for (std::size_t i = 0; i < checked.diagnostics.size() && i < 5; ++i) {
            fmt::print(stderr, "byte {}: {}\n", checked.diagnostics[i].span.begin,
                       checked.diagnostics[i].message);
        }
        return 1;
    }

    struct TokensAndTree {
        frontend::Tokens tokens;
        frontend::Cst cst;
    };
    std::vector<Measure> measures;
    measures.push_back(measure("lex", budget, [&] { return frontend::lex(text); }));
    measures.push_back(measure("lex, parse", budget, [&] {
        TokensAndTree both{frontend::lex(text), {}};
        both.cst = frontend::parse(both.tokens);
        return both;
    }));
    measures.push_back(measure("lex, parse, bind, check", budget,
                               [&] { return frontend::check(source::SourceId{0}, text); }));
    measures.push_back(
        measure("format with its proof", budget, [&] { return frontend::format(text); }));
    measures.push_back(measure("nlohmann::json, the same content", budget,
                               [&] { return nlohmann::json::parse(generated.json); }));
    const Measure& peer = measures.back();

    const std::string small = bench::generate_scene(10'000).scene;
    const double lint = lint_seconds(small);

    const auto size = static_cast<double>(text.size());
    if (as_json) {
        nlohmann::json out{{"bytes", text.size()},
                           {"json_bytes", generated.json.size()},
                           {"small_bytes", small.size()},
                           {"lint_process_seconds", lint}};
        for (const Measure& m : measures) {
            out["measures"].push_back({{"name", m.name},
                                       {"seconds", m.seconds},
                                       {"megabytes_per_second", size / m.seconds / 1e6},
                                       {"bytes_kept_per_byte", m.bytes_kept / size},
                                       {"times_as_fast_as_json", peer.seconds / m.seconds}});
        }
        fmt::print("{}\n", out.dump(2));
        return 0;
    }
    fmt::print("{:.1f} MB of scene, {:.1f} MB as JSON\n\n", size / 1e6,
               static_cast<double>(generated.json.size()) / 1e6);
    fmt::print("{:<34}{:>10}{:>10}{:>22}{:>10}\n", "", "ms", "MB/s", "kept per source byte",
               "x JSON");
    for (const Measure& m : measures) {
        fmt::print("{:<34}{:>10.1f}{:>10.1f}{:>22.2f}{:>10.1f}\n", m.name, m.seconds * 1e3,
                   size / m.seconds / 1e6, m.bytes_kept / size, peer.seconds / m.seconds);
    }
    if (lint > 0) {
        fmt::print("\ncobble lint of {:.1f} KB, whole process: {:.2f} ms\n",
                   static_cast<double>(small.size()) / 1e3, lint * 1e3);
    }
    return 0;
}
