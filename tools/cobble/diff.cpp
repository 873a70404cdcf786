// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "renderer/metrics/compare.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/driver/outputs.hpp"
#include "tools/driver/pictures.hpp"

namespace cobble {
namespace {

struct Options {
    std::string a, b;
    std::string map;
    double ppd = renderer::kDefaultPixelsPerDegree;
    double tolerance = -1;
    bool light = false;
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
    const renderer::Comparison result = renderer::compare(a.plane, b.plane, how);
    if (!result.error.empty()) {
        driver::complain(
            fmt::format("cannot compare {} with {}: {}", options.a, options.b, result.error));
        return kFailure;
    }
    const std::uint64_t pixels = std::uint64_t{a.plane.width} * a.plane.height;
    context.out.write(fmt::format(
        "MSE              {:.9g}\n"
        "relMSE           {:.9g}\n"
        "MAE              {:.9g}\n"
        "maximum          {:.9g}\n"
        "99th percentile  {:.9g}\n"
        "FLIP             {:.9g} (maximum {:.9g}; {:g} pixels per degree)\n"
        "differing        {} of {} pixels\n",
        result.mse, result.rel_mse, result.mae, result.maximum, result.percentile_99, result.flip,
        result.flip_maximum, result.pixels_per_degree, result.differing, pixels));
    if (result.clamped > 0) {
        context.out.write(fmt::format("clamped for FLIP {} values\n", result.clamped));
    }
    if (result.not_finite > 0) {
        context.out.write(fmt::format("not finite       {} pixels, left out\n", result.not_finite));
    }
    if (!options.map.empty()) {
        const std::string problem =
            driver::write_picture(options.map, renderer::heat_map(result.map), {});
        if (!problem.empty()) {
            driver::complain(problem);
            return kFailure;
        }
    }
    if (options.tolerance < 0) return kDone;
    // A pixel that is no number is no match.
    return result.maximum > options.tolerance || result.not_finite > 0 ? kFindings : kDone;
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
    sub->callback([options, &context] {
        context.run = [options, &context] { return run(*options, context); };
    });
}

}  // namespace cobble
