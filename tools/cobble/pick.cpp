// SPDX-License-Identifier: MIT
#include "renderer/pick/pick.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/view_options.hpp"
#include "tools/driver/numbers.hpp"
#include "tools/driver/report/pick_report.hpp"

namespace cobble {
namespace {

struct Options {
    ViewOptions view;
    std::string at;
    bool tree = false;
    bool json = false;
};

std::string check_pixel(const std::string& text) {
    std::vector<std::uint32_t> pixel;
    if (driver::parse_numbers(text, ',', 2, pixel)) return {};
    return fmt::format("'{}' is no pixel X,Y", text);
}

int run(const Options& options, Context& context) {
    const View view = make_view(options.view, true);
    if (view.status != 0) return view.status;
    std::vector<std::uint32_t> pixel;
    driver::parse_numbers(options.at, ',', 2, pixel);
    if (pixel[0] >= view.settings.width || pixel[1] >= view.settings.height) {
        driver::complain(fmt::format("--at: there is no pixel {} in a picture of {} (see --size)",
                                     options.at, options.view.size));
        return kFailure;
    }
    const ir::Scene& scene = view.loaded.lowered.scene;
    const renderer::PickTree tree = renderer::pick(scene, view.settings, pixel[0], pixel[1]);
    const driver::PickReport report{tree,     scene,    view.loaded.session->sources,
                                    pixel[0], pixel[1], options.tree};
    context.out.write(options.json ? driver::pick_to_json(report) : driver::pick_to_text(report));
    return kDone;
}

}  // namespace

void add_pick(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub =
        app.add_subcommand("pick", "Say what made a pixel, with the lines of the scene");
    add_view_options(*sub, options->view);
    sub->add_option("--at", options->at, "The pixel, Y from the top")
        ->type_name("X,Y")
        ->required()
        ->check(check_pixel);
    sub->add_flag("--tree", options->tree, "Show the reflected and refracted rays too");
    sub->add_flag("--json", options->json, "Print JSON");
    sub->callback([options, &context] {
        context.run = [options, &context] { return run(*options, context); };
    });
}

}  // namespace cobble
