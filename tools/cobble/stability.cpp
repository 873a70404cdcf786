// SPDX-License-Identifier: MIT
#include "renderer/stability/stability.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/view_options.hpp"
#include "tools/driver/report/stability_report.hpp"

namespace cobble {
namespace {

// An hour or two of them.
constexpr std::uint64_t kMostRays = 1000000000;

struct Options {
    ViewOptions view;
    std::uint64_t rays = renderer::StabilityOptions{}.rays;
    bool json = false;
};

int run(const Options& options, Context& context) {
    const View view = make_view("stability", options.view, true);
    if (view.status != 0) return view.status;
    const ir::Scene& scene = view.loaded.lowered.scene;
    const auto stability = renderer::measure_stability(scene, {options.rays, view.settings.height});
    const driver::StabilityReport report{stability,
                                         scene,
                                         view.loaded.session->sources,
                                         options.view.scene,
                                         view.settings.width,
                                         view.settings.height};
    context.out.write(options.json ? driver::stability_to_json(report)
                                   : driver::stability_to_text(report));
    return stability.clean() && !driver::has_errors(view.loaded.diagnostics) ? kDone : kFindings;
}

}  // namespace

void add_stability(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("stability", "Say how a scene stands up to float");
    sub->add_option("SCENE", options->view.scene, "The scene file, or - for standard input")
        ->required();
    add_size_option(*sub, options->view);
    require_whole(sub->add_option("--rays", options->rays,
                                  "Rays in all; no object gets more than a hundredth"),
                  1, kMostRays)
        ->type_name("N")
        ->capture_default_str();
    sub->add_flag("--json", options->json, "Print JSON");
    sub->add_flag("--keep-going", options->view.keep_going,
                  "Measure what is sound of a scene with errors");
    add_stdin_path(*sub, options->view.stdin_path);
    sub->footer(
        "Rays from the camera at vertices, edges, outlines and faces are cast in float and in "
        "double.\nA crack: float sees through. Changed: it sees what is not there. A self-hit: a "
        "ray that leaves\na surface meets it again. Each is counted only beyond what rounding "
        "explains, and none is\nexpected. ulps/pixel: the least number of float's steps across a "
        "pixel of the object; below 4\nneighbours look alike. Exit status 1 if there is a crack, a "
        "changed hit or a self-hit.");
    sub->callback([options, &context] {
        context.run = [options, &context] { return run(*options, context); };
    });
}

}  // namespace cobble
