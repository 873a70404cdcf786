// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/integrator/render_plan.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/usage.hpp"
#include "tools/cobble/view_options.hpp"
#include "tools/driver/load.hpp"
#include "tools/driver/report/effects_report.hpp"

namespace cobble {
namespace {

// The measure of a page for reading.
constexpr std::size_t kPageWidth = 80;

struct Options {
    bool listing = false;  ///< nothing is named
    ViewOptions view;      ///< its scene is whatever is named
    bool json = false;
    bool plan = false;
    std::vector<std::string> of_scenes;  ///< options given that only a scene can be asked with
};

// `text` in lines of at most kPageWidth bytes where words allow it, each line indented. Paragraphs
// are kept.
std::string wrapped(std::string_view text, std::string_view indent) {
    std::string result;
    std::string line(indent);
    const auto flush = [&] {
        if (line.size() > indent.size()) result += line + "\n";
        line = indent;
    };
    while (!text.empty()) {
        if (text.starts_with("\n\n")) {
            flush();
            result += "\n";
        }
        if (text.front() == ' ' || text.front() == '\n') {
            text.remove_prefix(1);
            continue;
        }
        const std::string_view word = text.substr(0, text.find_first_of(" \n"));
        if (line.size() > indent.size() && line.size() + 1 + word.size() > kPageWidth) flush();
        if (line.size() > indent.size()) line += ' ';
        line += word;
        text.remove_prefix(word.size());
    }
    flush();
    return result;
}

// A piece of scene text, each line indented.
std::string quoted(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (end > 0) result += "    " + std::string(text.substr(0, end));
        result += '\n';
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return result;
}

std::string_view article(source::Severity severity) {
    if (severity == source::Severity::kError) return "an error";
    return severity == source::Severity::kWarning ? "a warning" : "a remark";
}

int explain_code(const source::DiagnosticCode& code, Context& context) {
    std::string text =
        fmt::format("{}: {}\n\n{}\n{}\n", code.code, code.title, wrapped(code.why, ""),
                    wrapped(fmt::format("It is {}.", article(code.severity)), ""));
    if (!code.example.empty()) text += "For example:\n\n" + quoted(code.example) + "\n";
    if (!code.mend.empty()) text += wrapped(code.mend, "");
    context.out.write(text);
    return kDone;
}

int list_codes(Context& context) {
    for (const auto* code : source::all_codes()) {
        context.out.write(fmt::format("{:<32} {}\n", code->code, code->title));
    }
    return kDone;
}

/// Where no ray may go on, effects that send rays on do nothing.
void stop_at_once(ir::Effects& effects) {
    for (const ir::Effect effect : {ir::Effect::kReflection, ir::Effect::kRefraction}) {
        ir::EffectState& state = effects.states[static_cast<std::size_t>(effect)];
        if (state.on) state = {false, {}, "no ray goes on: --bounces 0"};
    }
}

int explain_scene(const Options& options, Context& context) {
    ir::LowerOptions lower;
    lower.compat = compat_of(options.view);
    if (options.plan && lower.compat != ir::Compat::kNone) {
        return usage_error("explain", "'--plan' is of Cobble's own way, not of '--compat'");
    }
    driver::LoadedScene loaded =
        driver::load_scene(options.view.scene, options.view.stdin_path, lower);
    if (loaded.session == nullptr) {
        driver::complain(loaded.problem);
        return kFailure;
    }
    const bool broken = driver::has_errors(loaded.diagnostics);
    report_to_error(loaded, true);
    std::string problem;
    renderer::Settings settings;
    settings.effects = choose_effects(loaded.lowered.scene, options.view, problem);
    if (!problem.empty()) return usage_error("explain", problem);
    settings.bounces = options.view.bounces;
    if (settings.bounces == 0) stop_at_once(settings.effects);
    if (options.view.precision == "double") settings.precision = renderer::Precision::kDouble;
    std::optional<renderer::RenderPlan> plan;
    if (options.plan) plan = renderer::plan_render(loaded.lowered.scene, settings);
    const source::SourceMap& sources = loaded.session->sources;
    const driver::EffectsReport report{
        settings.effects, sources, sources.path(loaded.session->scene), plan ? &*plan : nullptr};
    context.out.write(options.json ? driver::pretty(driver::effects_to_json(report))
                                   : driver::effects_to_text(report));
    return broken ? kFindings : kDone;
}

int run(const Options& options, Context& context) {
    const std::string& subject = options.view.scene;
    if (!stdin_path_is_used("explain", options.view.stdin_path, {subject})) return kFailure;
    const auto* const code = options.listing ? nullptr : source::find_code(subject);
    if ((options.listing || code != nullptr) && !options.of_scenes.empty()) {
        return usage_error("explain", fmt::format("'{}' is for a scene, not for diagnostics",
                                                  options.of_scenes.front()));
    }
    if (options.listing) return list_codes(context);
    if (subject.empty()) {
        return usage_error("explain", "CODE|SCENE wants a code or a file, not ''");
    }
    if (code != nullptr) return explain_code(*code, context);
    if (subject != "-" && access(subject.c_str(), F_OK) != 0) {
        const std::string similar = similar_code(subject);
        // With a slash or a dot it was meant as a file.
        const bool file = subject.find_first_of("/.") != std::string::npos;
        driver::complain(
            file && similar.empty()
                ? fmt::format("cannot read {}: there is no such file", subject)
                : fmt::format("there is neither a diagnostic nor a file '{}'{}", subject, similar));
        return kFailure;
    }
    return explain_scene(options, context);
}

}  // namespace

void add_explain(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand(
        "explain", "Explain a diagnostic, or what a scene calls for from its renderer");
    const CLI::Option* subject =
        sub->add_option("CODE|SCENE", options->view.scene,
                        "A code such as unexpected-argument, or a scene file (./FILE is always a "
                        "file); nothing lists all codes");
    add_stdin_path(*sub, options->view.stdin_path);
    const std::size_t of_both = sub->get_options().size();
    sub->add_flag("--json", options->json, "Print JSON");
    sub->add_flag("--plan", options->plan,
                  "Say how it would be rendered: the form of each stage, and the memory for it");
    add_choice(*sub, "--compat", options->view.compat, {"a4", "a5", "fa2016", "project"},
               "What it calls for from a published program: a4, a5, fa2016 or project");
    add_effect_options(*sub, options->view);
    sub->callback([options, sub, subject, of_both, &context] {
        options->listing = subject->count() == 0;
        const std::vector<CLI::Option*> all = sub->get_options();
        for (std::size_t i = of_both; i < all.size() - ir::kEffectCount; ++i) {
            if (all[i]->count() > 0) options->of_scenes.push_back(all[i]->get_name());
        }
        for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
            const int wanted = options->view.effects[i];
            if (wanted == 0) continue;
            options->of_scenes.push_back(fmt::format("--{}{}", wanted < 0 ? "no-" : "",
                                                     ir::name_of(static_cast<ir::Effect>(i))));
        }
        context.run = [options, &context] { return run(*options, context); };
    });
}

}  // namespace cobble
