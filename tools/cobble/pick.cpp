// SPDX-License-Identifier: MIT
#include "renderer/pick/pick.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/usage.hpp"
#include "tools/cobble/view_options.hpp"
#include "tools/driver/report/pick_report.hpp"

namespace cobble {
namespace {

struct Options {
    ViewOptions view;
    PixelPlace at;
    std::string compat;
    bool tree = false;
    bool json = false;
};

int run(const Options& options, Context& context) {
    if (!options.compat.empty()) {
        return usage_error("pick",
                           "'--compat' is for `cobble render` alone: only the rays of Cobble's own "
                           "way can be shown");
    }
    const View view = make_view("pick", options.view, true);
    if (view.status != 0) return view.status;
    const auto [x, y] = options.at;
    if (x >= view.settings.width || y >= view.settings.height) {
        return usage_error("pick", fmt::format("there is no pixel {},{} in a picture of {}: see "
                                               "'--size'",
                                               x, y, to_text(options.view.size)));
    }
    const ir::Scene& scene = view.loaded.lowered.scene;
    const renderer::PickTree tree = renderer::pick(scene, view.settings, x, y);
    const driver::PickReport report{tree, scene, view.loaded.session->sources, x, y, options.tree};
    context.out.write(options.json ? driver::pick_to_json(report) : driver::pick_to_text(report));
    if (!tree.complete) {
        context.out.flush();
        driver::complain(driver::incomplete_text(tree));
    }
    return kDone;
}

}  // namespace

void add_pick(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub =
        app.add_subcommand("pick", "Say what made a pixel, with the lines of the scene");
    add_view_options(*sub, options->view);
    add_parsed(*sub, "--at", "X,Y", "X,Y in whole numbers, such as 320,240", parse_pixel,
               options->at, "The pixel, Y from the top")
        ->required();
    // Left out of the help: said to be no option, it would look like a mistake.
    sub->add_option("--compat", options->compat)->group("");
    sub->add_flag("--tree", options->tree, "Show the reflected and refracted rays too");
    sub->add_flag("--json", options->json, "Print JSON");
    sub->callback([options, &context] {
        context.run = [options, &context] { return run(*options, context); };
    });
}

}  // namespace cobble
