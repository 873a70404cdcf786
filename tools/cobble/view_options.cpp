// SPDX-License-Identifier: MIT
#include "tools/cobble/view_options.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "ir/effects.hpp"
#include "renderer/picture/picture_io.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/usage.hpp"
#include "tools/driver/report/reporter.hpp"

namespace cobble {
namespace {

// A million samples a pixel are more than any scene's noise asks for.
constexpr std::uint32_t kMaxSamples = 1U << 20U;
// Of which each has samples of its own, of a 32-bit number.
constexpr std::uint32_t kMaxLightSamples = 1024;
// Nothing is left to see after so many mirrors.
constexpr std::uint32_t kMaxBounces = 1000;

/// What a command does with a scene.
std::string_view verb_of(std::string_view command) {
    if (command == "stability" || command == "cost") return "measures";
    return command == "pick" ? "picks from" : "renders";
}

ir::Compat compat_named(std::string_view name) {
    if (name == "a4") return ir::Compat::kA4;
    if (name == "a5") return ir::Compat::kA5;
    if (name == "fa2016") return ir::Compat::kFa2016;
    if (name == "project") return ir::Compat::kProject;
    return ir::Compat::kNone;
}

// What was asked of Cobble's own way, in vain where a published program's is followed.
std::vector<std::string> idle_options(const ViewOptions& options, const View& view) {
    const bool tracing = view.compat != ir::Compat::kA4 && !options.original_casting;
    const bool lens = view.compat == ir::Compat::kProject && options.original_casting &&
                      options.original_blurry > 0;
    std::vector<std::string_view> idle = {"--samples",      "--filter",         "--precision",
                                          "--reference",    "--texture-filter", "--focus-distance",
                                          "--light-samples"};
    if (!lens) idle.emplace_back("--aperture");
    if (!lens && !options.original_jitter) idle.emplace_back("--seed");
    if (!tracing) idle.emplace_back("--bounces");
    std::vector<std::string> result;
    for (const std::string& name : options.given) {
        if (std::find(idle.begin(), idle.end(), name) != idle.end()) result.push_back(name);
    }
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        const auto effect = static_cast<ir::Effect>(i);
        if (options.effects[i] == 0 || (effect == ir::Effect::kShadows && tracing)) continue;
        result.push_back(
            fmt::format("--{}{}", options.effects[i] < 0 ? "no-" : "", ir::name_of(effect)));
    }
    return result;
}

// What the published programs' flags ask for, or a word about those that mean nothing here.
void set_compat(const ViewOptions& options, View& view) {
    renderer::Settings::Compat& compat = view.settings.compat;
    compat.shadows = view.settings.effects.on(ir::Effect::kShadows);
    compat.jitter = options.original_jitter;
    compat.filter = options.original_filter;
    compat.casting = options.original_casting;
    compat.pixelated = options.original_pixelated;
    if (options.original_blurry >= 0) compat.blurry = options.original_blurry;
    if (view.compat != ir::Compat::kNone) {
        for (const std::string& name : idle_options(options, view)) {
            driver::complain(
                fmt::format("'{}' has no effect with --compat {}", name, options.compat), "render");
        }
        return;
    }
    const std::pair<bool, const char*> idle[] = {{options.original_jitter, "-jitter"},
                                                 {options.original_filter, "-filter"},
                                                 {options.original_casting, "-casting"},
                                                 {options.original_blurry >= 0, "-blurry"}};
    for (const auto& [given, name] : idle) {
        if (given) driver::complain(fmt::format("{} means nothing without --compat", name));
    }
    if (options.original_pixelated) view.settings.texture_filter = ir::TextureFilter::kNearest;
}

std::string set_lens(const ViewOptions& options, ir::Camera& camera) {
    if (options.aperture >= 0) camera.aperture = options.aperture;
    if (options.focus_distance > 0) camera.focus_distance = options.focus_distance;
    if (camera.aperture > 0 && camera.focus_distance <= 0) {
        return "'--aperture' needs '--focus-distance' here: the scene does not say what is in "
               "focus";
    }
    return {};
}

std::string what_is_missing(const ir::Lowered& lowered) {
    const std::string camera = "a PerspectiveCamera";
    if (!lowered.scene.objects.empty()) return "no camera: add " + camera;
    if (lowered.has_camera) return "no object to render: add one to its Group";
    return "neither a camera nor an object: add " + camera + ", and an object to its Group";
}

}  // namespace

void add_size_option(CLI::App& sub, ViewOptions& options) {
    add_parsed(sub, "--size", "WxH",
               fmt::format("WxH of 1 to {} pixels a side, such as 640x480", renderer::kMaxSide),
               parse_size, options.size, "Size of the picture in pixels")
        ->default_str(to_text(options.size));
}

void add_compat_options(CLI::App& sub, ViewOptions& options) {
    add_choice(sub, "--compat", options.compat, {"a4", "a5", "fa2016", "project"},
               "Render as a published program did: a4, a5, fa2016 or project");
    // Without a group an option is left out of the help: these are spelled with one dash there.
    const std::string hidden;
    sub.add_flag("--original-shadows", options.original_shadows)->group(hidden);
    sub.add_flag("--original-jitter", options.original_jitter)->group(hidden);
    sub.add_flag("--original-filter", options.original_filter)->group(hidden);
    sub.add_flag("--original-casting", options.original_casting)->group(hidden);
    sub.add_flag("--original-pixelated", options.original_pixelated)->group(hidden);
    require_number(sub.add_option("--original-blurry", options.original_blurry), 0)->group(hidden);
}

void add_effect_options(CLI::App& sub, ViewOptions& options) {
    require_whole(sub.add_option("--bounces", options.bounces,
                                 "How often a ray may be reflected or refracted"),
                  0, kMaxBounces)
        ->type_name("N")
        ->capture_default_str();
    add_choice(sub, "--precision", options.precision, {"float", "double"}, "float or double");
    require_number(
        sub.add_option("--aperture", options.aperture, "Diameter of the lens; 0 is a pinhole"), 0)
        ->type_name("A");
    require_above(sub.add_option("--focus-distance", options.focus_distance,
                                 "What is in focus is this far away"),
                  0)
        ->type_name("D");
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        const auto effect = static_cast<ir::Effect>(i);
        const std::string flags = fmt::format("--{0},!--no-{0}", ir::name_of(effect));
        sub.add_flag(flags, options.effects[i], std::string(ir::description_of(effect)))
            ->disable_flag_override()
            ->group("Effects (each is on where the scene calls for it)");
    }
}

void add_view_options(CLI::App& sub, ViewOptions& options) {
    sub.add_option("SCENE", options.scene, "The scene file, or - for standard input")->required();
    add_size_option(sub, options);
    require_whole(sub.add_option("--samples", options.samples, "Samples a pixel"), 1, kMaxSamples)
        ->type_name("N")
        ->capture_default_str();
    require_whole(sub.add_option("--light-samples", options.light_samples,
                                 "Places on each light with a size that a hit asks"),
                  1, kMaxLightSamples)
        ->type_name("N")
        ->capture_default_str();
    require_whole(sub.add_option("--seed", options.seed, "Another number, another noise"), 0,
                  std::numeric_limits<std::uint64_t>::max())
        ->type_name("N")
        ->capture_default_str();
    add_choice(sub, "--transfer", options.transfer, {"none", "srgb"},
               "none: work with display values as they are; srgb: decode pictures, work with "
               "light, encode the result");
    add_choice(sub, "--texture-filter", options.texture_filter, {"nearest", "bilinear"},
               "nearest or bilinear, whatever the materials say");
    sub.add_flag("--keep-going", options.keep_going,
                 "Render a scene with errors: what is broken is left out or shown in magenta");
    add_stdin_path(sub, options.stdin_path);
    add_effect_options(sub, options);
}

ir::Compat compat_of(const ViewOptions& options) { return compat_named(options.compat); }

ir::Effects choose_effects(ir::Scene& scene, const ViewOptions& options, std::string& problem) {
    const bool own_lens = scene.camera.aperture > 0;
    problem = set_lens(options, scene.camera);
    ir::Effects effects = ir::derive_effects(scene);
    ir::EffectState& lens = effects.states[static_cast<std::size_t>(ir::Effect::kDepthOfField)];
    if (lens.on && !own_lens) lens = {true, {}, "asked for: --aperture"};
    if (!lens.on && own_lens) lens = {false, {}, "switched off: --aperture 0"};
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        ir::EffectState& state = effects.states[i];
        const auto name = ir::name_of(static_cast<ir::Effect>(i));
        const int wanted = options.effects[i];
        if (wanted > 0 && !state.on) state = {true, {}, fmt::format("asked for: --{}", name)};
        if (wanted < 0 && state.on) state = {false, {}, fmt::format("switched off: --no-{}", name)};
    }
    ir::EffectState& shadows = effects.states[static_cast<std::size_t>(ir::Effect::kShadows)];
    const bool said = options.effects[static_cast<std::size_t>(ir::Effect::kShadows)] != 0;
    if (compat_of(options) != ir::Compat::kNone && !said) {
        if (options.original_shadows && !shadows.on) shadows = {true, {}, "asked for: -shadows"};
        if (!options.original_shadows && shadows.on) {
            shadows = {
                false, {}, fmt::format("off with --compat {} unless asked for", options.compat)};
        }
    }
    return effects;
}

void report_to_error(const driver::LoadedScene& loaded, bool errors_only) {
    const driver::ReportStyle style{driver::wants_color(STDERR_FILENO),
                                    driver::terminal_width(STDERR_FILENO, 100)};
    driver::FileReport report{loaded.session->scene, &loaded.session->sources, loaded.diagnostics};
    if (errors_only) {
        std::erase_if(report.diagnostics, [](const source::Diagnostic& diagnostic) {
            return diagnostic.severity != source::Severity::kError;
        });
    }
    driver::make_reporter(driver::ReportFormat::kHuman, style, driver::write_error)->file(report);
}

View make_view(std::string_view command, const ViewOptions& options, bool quiet) {
    View view;
    const auto give_up = [&view](int status, std::string_view message) {
        driver::complain(message);
        view.status = status;
    };
    if (!stdin_path_is_used(command, options.stdin_path, {options.scene})) {
        view.status = kFailure;
        return view;
    }
    view.compat = compat_of(options);
    ir::LowerOptions lower;
    lower.compat = view.compat;
    lower.casting = options.original_casting;
    lower.decode_srgb = options.transfer == "srgb";
    // The published programs' ways are all traced in double.
    lower.judge_float = view.compat == ir::Compat::kNone && options.precision == "float";
    lower.size = {options.size.width, options.size.height};
    view.loaded = driver::load_scene(options.scene, options.stdin_path, lower);
    if (view.loaded.session == nullptr) {
        give_up(kFailure, view.loaded.problem);
        return view;
    }
    report_to_error(view.loaded, quiet);
    const std::string name = options.scene == "-" ? "the scene" : options.scene;
    if (driver::has_errors(view.loaded.diagnostics) && !options.keep_going) {
        give_up(kFindings, fmt::format("{} has errors (--keep-going {} what is sound)", name,
                                       verb_of(command)));
        return view;
    }
    if (!view.loaded.lowered.renderable) {
        give_up(kFindings, name + " has " + what_is_missing(view.loaded.lowered));
        return view;
    }
    ir::Scene& scene = view.loaded.lowered.scene;
    std::string problem;
    renderer::Settings& settings = view.settings;
    settings.effects = choose_effects(scene, options, problem);
    if (!problem.empty()) {
        view.status = usage_error(command, problem);
        return view;
    }
    settings.width = options.size.width;
    settings.height = options.size.height;
    settings.crop = options.crop;
    settings.samples = options.samples;
    settings.light_samples = options.light_samples;
    settings.bounces = options.bounces;
    settings.seed = options.seed;
    settings.precision =
        options.precision == "double" ? renderer::Precision::kDouble : renderer::Precision::kFloat;
    if (options.texture_filter == "nearest") settings.texture_filter = ir::TextureFilter::kNearest;
    if (options.texture_filter == "bilinear") {
        settings.texture_filter = ir::TextureFilter::kBilinear;
    }
    set_compat(options, view);
    return view;
}

}  // namespace cobble
