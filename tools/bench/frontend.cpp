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

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/format/format.hpp"
#include "frontend/lex/tokens.hpp"
#include "frontend/parse/cst.hpp"
#include "tools/bench/report.hpp"
#include "tools/bench/scene_generator.hpp"
#include "tools/bench/timing.hpp"

namespace {

using namespace cobble;
using bench::at_least;
using bench::at_most;
using bench::Limit;

struct Measure {
    std::string name;
    Limit speed;
    double seconds = 0;
    double bytes_kept = 0;  ///< live heap after the run less before
};

double live_bytes() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

/// `run` returns what it built, which is timed without its destruction and weighed.
template <typename Run>
Measure measure(std::string name, Limit speed, double budget, Run run) {
    Measure result{std::move(name), speed};
    constexpr int kLeastRuns = 3;
    result.seconds = bench::best_seconds(budget, kLeastRuns, run);
    const double before = live_bytes();
    const auto built = run();
    result.bytes_kept = live_bytes() - before;
    return result;
}

/// `cobble lint FILE` from start to exit: the least wall time and the least processor time of the
/// runs that fit into two seconds, at least 50. Exits if the file has errors.
bench::ProcessTime lint_time(const std::string& path) {
    constexpr int kLeastRuns = 50;
    constexpr double kBudget = 2;
    bench::ProcessTime best{kBudget, kBudget};
    const auto start = bench::Clock::now();
    for (int i = 0; i < kLeastRuns || bench::seconds_since(start) < kBudget; ++i) {
        const auto time = bench::run_process({COBBLE_PROGRAM, "lint", path});
        if (!time) {
            fmt::print(stderr, "cobble lint {} failed\n", path);
            std::exit(1);
        }
        best.wall_seconds = std::min(best.wall_seconds, time->wall_seconds);
        best.processor_seconds = std::min(best.processor_seconds, time->processor_seconds);
    }
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
    measures.push_back(measure("lex", {}, budget, [&] { return frontend::lex(text); }));
    measures.push_back(measure("lex, parse", at_least(200), budget, [&] {
        TokensAndTree both{frontend::lex(text), {}};
        both.cst = frontend::parse(both.tokens);
        return both;
    }));
    measures.push_back(measure("lint: lex, parse, bind, check", at_least(100), budget,
                               [&] { return frontend::check(source::SourceId{0}, text); }));
    measures.push_back(measure("format with its proof", at_least(50), budget,
                               [&] { return frontend::format(text); }));
    measures.push_back(measure("nlohmann::json, same content", {}, budget,
                               [&] { return nlohmann::json::parse(generated.json); }));
    const Measure& peer = measures.back();
    constexpr Limit kKept = at_most(8);
    constexpr Limit kLint = at_most(10);

    const bench::TemporaryFile small(bench::generate_scene(10'000).scene, ".scene");
    const struct {
        std::string what, path;
    } files[] = {{"generated", small.path()},
                 {"scenes/basics/phong.scene", COBBLE_ROOT "/scenes/basics/phong.scene"},
                 {"scenes/village/characters.scene, 14 textures",
                  COBBLE_ROOT "/scenes/village/characters.scene"}};

    const auto size = static_cast<double>(text.size());
    if (as_json) {
        nlohmann::json out{{"bytes", text.size()}, {"json_bytes", generated.json.size()}};
        for (const Measure& m : measures) {
            out["measures"].push_back({{"name", m.name},
                                       {"seconds", m.seconds},
                                       {"megabytes_per_second", size / m.seconds / 1e6},
                                       {"bytes_kept_per_byte", m.bytes_kept / size},
                                       {"times_as_fast_as_json", peer.seconds / m.seconds}});
        }
        for (const auto& file : files) {
            out["lint_process"].push_back({{"name", file.what},
                                           {"bytes", std::filesystem::file_size(file.path)},
                                           {"seconds", lint_time(file.path).wall_seconds}});
        }
        fmt::print("{}\n", out.dump(2));
        return 0;
    }
    fmt::print("== Front end: {:.1f} MB of generated scene, one thread, processor time\n\n",
               size / 1e6);
    fmt::print("{:<31}{:>8}{:>8}{:>8}  {:<24}{:>11}  {}\n", "", "ms", "MB/s", "x JSON", "speed",
               "kept B/byte", "memory");
    for (const Measure& m : measures) {
        const double speed = size / m.seconds / 1e6;
        const double kept = m.bytes_kept / size;
        fmt::print("{:<31}{:>8.1f}{:>8.1f}{:>8.2f}  {:<24}{:>11.2f}  {}\n", m.name, m.seconds * 1e3,
                   speed, peer.seconds / m.seconds, m.speed.verdict(speed), kept,
                   &m == &peer ? "" : kKept.verdict(kept));
    }
    fmt::print(
        "MB/s: 10^6 bytes of scene text a second, for the JSON reader too, whose {:.1f} MB say the "
        "same.\nx JSON: how many times as fast as nlohmann::json reads that.\n",
        static_cast<double>(generated.json.size()) / 1e6);
    fmt::print("\n{:<48}{:>6}{:>8}{:>15}\n", "cobble lint, whole process", "KB", "ms",
               "processor ms");
    for (const auto& file : files) {
        const bench::ProcessTime time = lint_time(file.path);
        fmt::print("{:<48}{:>6.1f}{:>8.2f}{:>15.2f}  {}\n", file.what,
                   static_cast<double>(std::filesystem::file_size(file.path)) / 1e3,
                   time.wall_seconds * 1e3, time.processor_seconds * 1e3,
                   kLint.verdict(time.wall_seconds * 1e3));
    }
    fmt::print("\n");
    return 0;
}
