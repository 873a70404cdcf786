// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "renderer/metrics/compare.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/driver/outputs.hpp"
#include "tools/driver/pictures.hpp"
#include "tools/driver/report/difference_report.hpp"

namespace cobble {
namespace {

struct Options {
    std::string a, b;
    std::string map;
    double ppd = renderer::kDefaultPixelsPerDegree;
    std::optional<double> tolerance;
    bool light = false;
    bool json = false;
};

// Before anything is compared: whether the map has a place to go.
std::string check_map(const Options& options) {
    if (options.map.empty()) return {};
    std::string problem = driver::check_distinct({options.map}, {options.a, options.b});
    return problem.empty() ? driver::check_picture_path(options.map, 1, 1, 3) : problem;
}

int run(const Options& options, Context& context) {
    if (const std::string problem = check_map(options); !problem.empty()) {
        driver::complain(problem);
        return kFailure;
    }
    const driver::ReadPicture a = driver::read_picture(options.a);
    const driver::ReadPicture b = driver::read_picture(options.b);
    for (const auto* picture : {&a, &b}) {
        if (picture->problem.empty()) continue;
        driver::complain(picture->problem);
        return kFailure;
    }
    renderer::CompareOptions how;
    how.pixels_per_degree = options.ppd;
    how.light_a = options.light && !a.eight_bit;
    how.light_b = options.light && !b.eight_bit;
    how.threads = 0;
    if (options.tolerance) how.tolerance = *options.tolerance;
    const renderer::Comparison result = renderer::compare(a.plane, b.plane, how);
    if (!result.error.empty()) {
        driver::complain(
            fmt::format("cannot compare {} with {}: {}", options.a, options.b, result.error));
        return kFailure;
    }
    const driver::DifferenceReport report{result,        options.a,      options.b,
                                          a.plane.width, a.plane.height, options.tolerance};
    context.out.write(options.json ? driver::difference_to_json(report)
                                   : driver::difference_to_text(report));
    if (!options.map.empty()) {
        const std::string problem =
            driver::write_picture(options.map, renderer::heat_map(result.map), {});
        if (!problem.empty()) {
            driver::complain(problem);
            return kFailure;
        }
    }
    return options.tolerance && !report.within_tolerance() ? kFindings : kDone;
}

}  // namespace

void add_diff(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("diff", "Compare two pictures");
    sub->add_option("A", options->a, "The picture to measure against")->required();
    sub->add_option("B", options->b, "The other picture, of the same size")->required();
    require_number(
        sub->add_option("--ppd", options->ppd, "Pixels per degree of the viewer's sight, for FLIP"),
        1, 4000)
        ->type_name("P")
        ->capture_default_str();
    require_number(
        sub->add_option("--tolerance", options->tolerance,
                        "Exit with 1 if any value differs by more than T (1 is black to white)"),
        0)
        ->type_name("T");
    sub->add_option("-o", options->map, "Write a map of FLIP to this picture file")
        ->type_name("MAP");
    sub->add_flag("--light", options->light,
                  "Pictures of floating-point numbers hold light, not display values (for FLIP)");
    sub->add_flag("--json", options->json, "Print JSON");
    sub->footer(
        "MSE, relMSE (relative to A), MAE, maximum and 99th percentile are of the numbers as they "
        "are, 1\nbeing white. FLIP is what an eye sees that flips between the two: 0 nothing, 1 as "
        "much as can be.\n"
        "Exit status with --tolerance: 1 if it is exceeded or a pixel is not finite; without it 0, "
        "however\nmuch they differ; 2 if they cannot be compared.\n"
        "\n"
        "Are two pictures the same but for rounding to 8 bits, and if not, where?\n"
        "  cobble diff old.png new.png --tolerance 0.004 -o where.png");
    sub->callback([options, &context] {
        context.run = [options, &context] { return run(*options, context); };
    });
}

}  // namespace cobble
