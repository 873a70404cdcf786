// SPDX-License-Identifier: MIT
#include "ir/json.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "ir/hash.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/view_options.hpp"
#include "tools/driver/load.hpp"

namespace cobble {
namespace {

struct Options {
    std::string scene;
    std::string stdin_path;
    bool hash = false;
    bool keep_going = false;
};

int run(const Options& options, Context& context) {
    if (!stdin_path_is_used("ir", options.stdin_path, {options.scene})) return kFailure;
    const driver::LoadedScene loaded = driver::load_scene(options.scene, options.stdin_path, {});
    if (loaded.session == nullptr) {
        driver::complain(loaded.problem);
        return kFailure;
    }
    report_to_error(loaded, false);
    const bool broken = driver::has_errors(loaded.diagnostics);
    if (broken && !options.keep_going) return kFindings;
    const ir::Scene& scene = loaded.lowered.scene;
    std::string text = options.hash ? ir::hash(scene) : ir::to_json(scene, loaded.session->sources);
    if (!text.ends_with('\n')) text += '\n';
    context.out.write(text);
    return broken ? kFindings : kDone;
}

}  // namespace

void add_ir(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("ir", "Print the checked scene as JSON");
    sub->add_option("SCENE", options->scene, "The scene file, or - for standard input")->required();
    sub->add_flag("--hash", options->hash,
                  "Print its SHA-256 instead, which is the same for files that mean the same");
    sub->add_flag("--keep-going", options->keep_going, "Print what is sound of a broken scene");
    add_stdin_path(*sub, options->stdin_path);
    sub->callback([options, &context] {
        context.run = [options, &context] { return run(*options, context); };
    });
}

}  // namespace cobble
