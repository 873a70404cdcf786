// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "frontend/dump/dump.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/view_options.hpp"
#include "tools/driver/load.hpp"

namespace cobble {
namespace {

struct Options {
    std::string phase;
    std::string scene;
};

int run(const Options& options, Context& context) {
    const driver::LoadedScene loaded = driver::check_scene(options.scene, "");
    if (loaded.session == nullptr) {
        driver::complain(loaded.problem);
        return kFailure;
    }
    const frontend::CheckedScene& scene = loaded.session->checked;
    if (options.phase == "tokens") context.out.write(frontend::dump_tokens(scene.tokens));
    if (options.phase == "cst") context.out.write(frontend::dump_cst(scene.tokens, scene.cst));
    if (options.phase == "ast")
        context.out.write(frontend::dump_ast(scene.tokens, scene.cst, scene.ast));
    // Any bytes are tokens; what is broken in them shows later.
    if (options.phase == "tokens" || !driver::has_errors(loaded.diagnostics)) return kDone;
    context.out.flush();
    report_to_error(loaded, true);
    return kFindings;
}

}  // namespace

void add_dump(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("dump", "Print what one phase made of a scene");
    add_choice(*sub, "PHASE", options->phase, {"tokens", "cst", "ast"}, "Which phase")->required();
    sub->add_option("SCENE", options->scene, "The scene file, or - for standard input")->required();
    sub->callback([options, &context] {
        context.run = [options, &context] { return run(*options, context); };
    });
}

}  // namespace cobble
