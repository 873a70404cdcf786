// SPDX-License-Identifier: MIT
// Millions of rays a second: our cores by instruction set, and Embree on the same rays if it was
// there when this was built.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <vector>

#include "tools/bench/inputs/input.hpp"
#include "tools/bench/rays/run.hpp"

namespace {

using namespace cobble::bench;

std::string description() {
    std::string text =
        "Millions of rays a second of our cores and, if it was there when this was built, Embree.\n"
        "All that is compared takes turns on the same rays; figures are medians over passes, and\n"
        "ratios medians over passes of two neighbours' ratio. One thread is timed by the "
        "processor\n"
        "time that it gets, so that other programs disturb less; more threads by wall time.\n"
        "Making rays is not timed. Exits with 1 if the fast core's answers differ from the\n"
        "reference's in any bit.\n\nInputs:\n";
    for (const InputName& input : input_names()) {
        text += fmt::format("  {:<12}{}{}\n", input.name, input.what,
                            input.on_request ? " (only if named)" : "");
    }
    text += "Kinds:\n";
    for (const RayKind& kind : kRayKinds) text += fmt::format("  {:<12}{}\n", kind.name, kind.what);
    text += "  build       seconds to build, and bytes a primitive\n";
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> all_inputs;
    std::vector<std::string> inputs;
    for (const InputName& input : input_names()) {
        all_inputs.emplace_back(input.name);
        if (!input.on_request) inputs.emplace_back(input.name);
    }
    Choice choice;
    for (const RayKind& kind : kRayKinds) choice.kinds.emplace_back(kind.name);
    choice.kinds.emplace_back("build");
    const std::vector<std::string> all_kinds = choice.kinds;

    CLI::App app{description()};
    std::vector<std::string> files;
    bool json = false;
    bool twice = false;
    app.add_option("--obj", files, "OBJ files to measure with, in place of the inputs")
        ->check(CLI::ExistingFile);
    app.add_option("--inputs", inputs, "some of the inputs, with commas between")
        ->delimiter(',')
        ->check(CLI::IsMember(all_inputs));
    app.add_option("--kinds", choice.kinds, "some of the kinds, with commas between")
        ->delimiter(',')
        ->check(CLI::IsMember(all_kinds));
    app.add_option("--cores", choice.cores,
                   "only cores with one of these words in their names, with commas between")
        ->delimiter(',');
    app.add_option("--threads", choice.threads, "numbers of threads, with commas between")
        ->delimiter(',')
        ->check(CLI::Range(1U, 256U));
    app.add_option("--width", choice.size.width, "of the picture whose rays are traced")
        ->check(CLI::Range(8U, 16384U));
    app.add_option("--height", choice.size.height, "of the picture whose rays are traced")
        ->check(CLI::Range(8U, 16384U));
    app.add_option("--passes", choice.effort.passes, "for each figure, at least")
        ->check(CLI::Range(1U, 10000U));
    app.add_option("--seconds", choice.effort.seconds, "for each figure, at least")
        ->check(CLI::Range(0.0, 600.0));
    app.add_flag("--double", twice, "our cores in double precision");
    app.add_flag("--json", json, "JSON instead of a table");
    CLI11_PARSE(app, argc, argv);

    Report report(json);
    report.begin();
    std::uint64_t differences = 0;
    const auto run = [&](const Input& input) {
        differences += twice ? run_input<double>(input, choice, report)
                             : run_input<float>(input, choice, report);
    };
    for (const std::string& path : files) {
        std::string problem;
        const auto input = read_input(path, problem);
        if (!input) {
            fmt::print(stderr, "bench_rays: {}\n", problem);
            return 2;
        }
        run(*input);
    }
    if (files.empty() || app.count("--inputs") > 0) {
        for (const std::string& name : inputs) run(make_input(name));
    }
    report.end();
    if (differences > 0) {
        fmt::print(stderr, "bench_rays: {} answers differ from the reference's\n", differences);
        return 1;
    }
    return 0;
}
