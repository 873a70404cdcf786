// SPDX-License-Identifier: MIT
#include "renderer/cost/study.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/cost/parts.hpp"

namespace cobble::renderer {
namespace {

// When each part should be over, of all the time.
constexpr double kCurveUntil = 0.35;
constexpr double kStagesPart = 0.03;
constexpr double kEffectsUntil = 0.5;
constexpr double kNoiseUntil = 0.75;
constexpr double kRungsUntil = 1;
// Enough for a band of some tenths of a share; more make it narrower.
constexpr std::uint32_t kFewestPairs = 8;
constexpr std::uint32_t kMostPairs = 32;

/// Samples a pixel, a power of two from 2 to 64 (a single one is the pixel's middle, and has not
/// the noise of others), of pictures of which `pictures` are made in `seconds`.
std::uint32_t samples_for(const CurveStudy& curve, double seconds, double pictures) {
    std::uint32_t samples = 2;
    while (samples < 64 &&
           pictures * (curve.prepare_seconds + 2 * samples * curve.sample_seconds) <= seconds) {
        samples *= 2;
    }
    return samples;
}

}  // namespace

std::optional<CostReport> study_cost(const ir::Scene& scene, const Settings& settings,
                                     Scheduler& scheduler, const StudyOptions& options,
                                     const Interrupted& interrupted,
                                     const StudyProgress& progress) {
    const Studio studio(scene, settings, scheduler, options, interrupted);
    CostReport report;
    report.width = settings.width;
    report.height = settings.height;
    report.seed = settings.seed;
    report.light_samples = settings.light_samples;
    report.bounces = settings.bounces;
    report.asked_precision = settings.precision;
    report.threads = scheduler.workers();
    report.pixels_per_degree = options.pixels_per_degree;
    const auto begin = [&](std::string_view part) {
        progress(part, std::min(studio.seconds() / options.seconds, 1.0));
    };
    const auto seconds_until = [&](double part) {
        return std::max(part * options.seconds - studio.seconds(), 0.0);
    };

    begin("error over time");
    std::optional<CurveStudy> curve = study_curve(studio, kCurveUntil);
    if (!curve) return std::nullopt;
    report.curve = curve->curve;

    begin("stages");
    const double stage_seconds = kStagesPart * options.seconds;
    auto stages = study_stages(studio, samples_for(*curve, stage_seconds, 1));
    if (!stages) return std::nullopt;
    report.stages = std::move(*stages);

    begin("effects");
    double effects = 1;
    for (const ir::EffectState& state : settings.effects.states) effects += state.on ? 1 : 0;
    const std::uint32_t samples = samples_for(*curve, seconds_until(kEffectsUntil), 3 * effects);
    auto bills = study_effects(studio, samples, kEffectsUntil);
    if (!bills) return std::nullopt;
    report.effects = std::move(bills->bills);
    report.effect_samples = samples;
    report.effect_runs = bills->runs;

    begin("noise");
    double sources = 1;
    for (const ir::Effect effect :
         {ir::Effect::kDepthOfField, ir::Effect::kMotionBlur, ir::Effect::kSoftShadows}) {
        sources += settings.effects.on(effect) ? 1 : 0;
    }
    const double noise_seconds = seconds_until(kNoiseUntil);
    const std::uint32_t noise_samples =
        std::min(samples_for(*curve, noise_seconds, kFewestPairs * (sources + 2)), 16U);
    const double of_pair =
        (sources + 2) * (curve->prepare_seconds + noise_samples * curve->sample_seconds);
    const auto pairs = static_cast<std::uint32_t>(
        std::clamp(noise_seconds / std::max(of_pair, 1e-9), 1.0 * kFewestPairs, 1.0 * kMostPairs));
    auto noise = study_noise(studio, noise_samples, pairs);
    if (!noise) return std::nullopt;
    report.noise = std::move(*noise);

    begin("precision");
    const auto precision = study_precision(studio, samples);
    if (!precision) return std::nullopt;
    report.precision = *precision;

    begin("bias");
    auto biases = study_biases(studio, samples);
    if (!biases) return std::nullopt;
    report.biases = std::move(*biases);

    begin("choices");
    auto rungs = study_rungs(studio, *curve, kRungsUntil);
    if (!rungs) return std::nullopt;
    report.rungs = std::move(*rungs);
    report.recommendation = recommend(report);
    report.study_seconds = studio.seconds();
    return report;
}

}  // namespace cobble::renderer
