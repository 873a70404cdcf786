// SPDX-License-Identifier: MIT
// Texts that nobody writes: what ten times as much of them costs. Linear work takes ten times as
// long (somewhat more where the first text fits into the caches), quadratic work a hundred times.
//
//   bench_growth [--json]
//
// Processor time, the best of three runs; checking stops at its usual number of findings.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/format/format.hpp"
#include "tools/bench/report.hpp"
#include "tools/bench/timing.hpp"

namespace {

using namespace cobble;

std::string repeated(std::string_view piece, std::size_t count) {
    std::string text;
    text.reserve(piece.size() * count);
    for (std::size_t i = 0; i < count; ++i) text += piece;
    return text;
}

struct Shape {
    const char* name;
    std::size_t count;  ///< of the smaller text
    std::function<std::string(std::size_t)> make;
};

/// The larger texts are those that must be borne: a million nested blocks, a line of 100 MB.
std::vector<Shape> shapes() {
    constexpr std::string_view kSphere = "Sphere { center 1.25 -0.5 1e3 radius 12.125 } ";
    constexpr std::size_t kTenMegabytes = 10'000'000;
    return {
        {"1 000 000 nested blocks", 100'000,
         [](std::size_t n) { return repeated("Group { ", n) + repeated("} ", n); }},
        {"1 000 000 nested blocks, no brace closed", 100'000,
         [](std::size_t n) { return repeated("Group {\n", n); }},
        {"1 000 000 unknown blocks in each other", 100'000,
         [](std::size_t n) { return repeated("Unknown { ", n); }},
        {"a line of 100 MB", kTenMegabytes / kSphere.size(),
         [kSphere](std::size_t n) {
             return "Group { MaterialIndex 0 " + repeated(kSphere, n) + "}";
         }},
        {"a number of 100 MB", kTenMegabytes, [](std::size_t n) { return std::string(n, '7'); }},
        {"a comment of 100 MB", kTenMegabytes,
         [](std::size_t n) { return "// " + std::string(n, '7'); }},
    };
}

struct Row {
    std::string text, phase;
    double megabytes = 0;
    double seconds = 0;  ///< of the larger text
    double times = 0;    ///< as long as the smaller one
};

template <typename Run>
Row measure(const Shape& shape, const char* phase, Run run) {
    constexpr int kRuns = 3;
    const std::string small = shape.make(shape.count);
    const std::string large = shape.make(10 * shape.count);
    const double first = bench::best_seconds(0, kRuns, [&] { return run(small); });
    const double second = bench::best_seconds(0, kRuns, [&] { return run(large); });
    return {shape.name, phase, static_cast<double>(large.size()) / 1e6, second, second / first};
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("What ten times as much text costs");
    bool as_json = false;
    app.add_flag("--json", as_json, "print JSON");
    CLI11_PARSE(app, argc, argv);

    std::vector<Row> rows;
    for (const Shape& shape : shapes()) {
        rows.push_back(measure(shape, "lint", [](const std::string& text) {
            return frontend::check(source::SourceId{0}, text);
        }));
        rows.push_back(measure(shape, "format",
                               [](const std::string& text) { return frontend::format(text); }));
    }
    if (as_json) {
        auto all = nlohmann::json::array();
        for (const Row& row : rows) {
            all.push_back({{"text", row.text},
                           {"phase", row.phase},
                           {"megabytes", row.megabytes},
                           {"seconds", row.seconds},
                           {"times_as_long_as_a_tenth", row.times}});
        }
        fmt::print("{}\n", all.dump(2));
        return 0;
    }
    // Linear work takes about 10 times as long and quadratic 100. The limit lies half way: where
    // the small text fits into the caches, linear work takes up to 30.
    constexpr bench::Limit kLinear = bench::at_most(50);
    fmt::print(
        "== Growth: ten times as much text (linear is 10, quadratic 100), one thread, processor "
        "time\n\n");
    fmt::print("{:<42}{:<8}{:>8}{:>10}{:>9}{:>18}\n", "", "phase", "MB", "ms", "MB/s",
               "x a tenth of it");
    for (const Row& row : rows) {
        fmt::print("{:<42}{:<8}{:>8.1f}{:>10.1f}{:>9.1f}{:>18.1f}  {}\n", row.text, row.phase,
                   row.megabytes, row.seconds * 1e3, row.megabytes / row.seconds, row.times,
                   kLinear.verdict(row.times));
    }
    fmt::print("\n");
    return 0;
}
