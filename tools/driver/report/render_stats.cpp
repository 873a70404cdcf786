// SPDX-License-Identifier: MIT
#include "tools/driver/report/render_stats.hpp"

#include <fmt/core.h>
#include <sys/resource.h>

#include <utility>

#include "tools/driver/report/diagnostic_json.hpp"
#include "tools/driver/report/object_words.hpp"
#include "tools/driver/report/preparation_notes.hpp"

namespace cobble::driver {
namespace {

std::uint64_t peak_bytes() {
    struct rusage usage {};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

/// What was asked of the error, and what it came to; null if the render cannot tell.
Json accuracy_to_json(const renderer::Settings& settings, const renderer::Stats& stats) {
    if (!stats.achieved) return nullptr;
    const renderer::Achieved& achieved = *stats.achieved;
    Json json = {{"rms", achieved.rms},
                 {"within_99_percent", achieved.percentile_99},
                 {"within_all", achieved.largest},
                 {"samples", achieved.samples},
                 {"fewest_samples", achieved.fewest},
                 {"most_samples", achieved.most}};
    if (settings.goal) {
        constexpr std::string_view kMethods[] = {"adaptive", "unbiased", "guarantee"};
        json["goal"] = {{"error", settings.goal->error},
                        {"method", kMethods[static_cast<std::size_t>(settings.goal->method)]},
                        {"max_samples", settings.goal->most_samples},
                        {"pixels_beyond", achieved.beyond_goal}};
    }
    return json;
}

}  // namespace

std::string stats_to_json(const RenderStats& render) {
    const renderer::Stats& stats = render.stats;
    const renderer::Counters& counters = stats.counters;
    Json phases = Json::array();
    const auto add = [&phases](std::string_view name, double seconds) {
        phases.push_back({{"name", name}, {"seconds", seconds}});
    };
    add("read", render.loaded.read_seconds);
    add("check", render.loaded.check_seconds);
    add("lower", render.loaded.lower_seconds);
    for (const renderer::PhaseTime& phase : stats.phases) {
        add(phase.name, phase.seconds);
        if (phase.processor_seconds > 0) {
            phases.back()["processor_seconds"] = phase.processor_seconds;
        }
    }
    add("write", render.write_seconds);

    Json stages = Json::array();
    for (std::size_t i = 0; i < renderer::kTimedStages; ++i) {
        const double seconds = stats.stages.seconds[i];
        if (seconds == 0) continue;
        const auto stage = static_cast<renderer::TimedStage>(i);
        stages.push_back({{"name", renderer::name_of(stage)}, {"seconds", seconds}});
    }

    Positions positions(render.loaded.session->sources);
    Json bad = Json::array();
    for (const renderer::BadSample& sample : stats.bad_samples) {
        Json entry = {{"x", sample.x}, {"y", sample.y}, {"sample", sample.sample}};
        if (sample.span.valid()) entry["object"] = place_of(sample.span, positions);
        bad.push_back(std::move(entry));
    }
    Json effects = Json::array();
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        const auto effect = static_cast<ir::Effect>(i);
        if (render.settings.effects.on(effect)) effects.push_back(ir::name_of(effect));
    }
    const ir::Scene& scene = render.loaded.lowered.scene;
    const Json json = {
        {"cobble_stats", 1},
        {"picture",
         {{"width", render.settings.width},
          {"height", render.settings.height},
          {"samples", render.settings.goal ? Json() : Json(render.settings.samples)},
          {"scrambles", render.settings.goal ? Json() : Json(render.settings.scrambles)},
          {"bounces", render.settings.bounces},
          {"seed", render.settings.seed},
          {"complete", render.complete}}},
        {"accuracy", accuracy_to_json(render.settings, stats)},
        {"effects", std::move(effects)},
        {"phases", std::move(phases)},
        // Of all workers together.
        {"stages", std::move(stages)},
        {"workers", stats.workers},
        {"rays",
         {{"camera", counters.camera_rays},
          {"shadow", counters.shadow_rays},
          {"reflected", counters.reflected_rays},
          {"refracted", counters.refracted_rays},
          {"total", counters.rays()}}},
        {"rays_per_second", render.progress.seconds > 0
                                ? static_cast<double>(counters.rays()) / render.progress.seconds
                                : 0.0},
        {"tests", {{"boxes", counters.box_tests}, {"primitives", counters.primitive_tests}}},
        {"draws",
         {{"lens", counters.lens_draws},
          {"time", counters.time_draws},
          {"light", counters.light_draws}}},
        {"lookups",
         {{"texture", counters.texture_lookups},
          {"normal_map", counters.normal_map_lookups},
          {"noise", counters.noise_evaluations},
          {"cube_map", counters.cube_map_lookups},
          {"highlight", counters.highlights}}},
        {"memory", {{"scene_bytes", stats.scene_bytes}, {"peak_bytes", peak_bytes()}}},
        {"notes",
         notes_to_json(stats.notes, scene, positions, prepared_in(scene, render.settings))},
        {"bad_samples", {{"count", stats.bad_sample_count}, {"first", std::move(bad)}}}};
    return pretty(json);
}

std::string bad_sample_text(const renderer::Stats& stats, const source::SourceMap& sources) {
    std::string text = fmt::format("{} sample{} came out infinite or not a number and {} left out",
                                   stats.bad_sample_count, stats.bad_sample_count == 1 ? "" : "s",
                                   stats.bad_sample_count == 1 ? "was" : "were");
    if (stats.bad_samples.empty()) return text;
    const renderer::BadSample& first = stats.bad_samples.front();
    text += fmt::format("; the first is sample {} of pixel {},{}", first.sample, first.x, first.y);
    Positions positions(sources);
    if (first.span.valid()) text += ", on the object of " + place_of(first.span, positions);
    return text;
}

}  // namespace cobble::driver
