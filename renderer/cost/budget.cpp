// SPDX-License-Identifier: MIT
#include "renderer/cost/budget.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "ir/math/elementary.hpp"

namespace cobble::renderer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kUsable = 0.97;  ///< of what is left: clocks and neighbours are not exact
// Trials end where the next one would take this part of the time; a second one, for the sake of how
// errors fall, may take more.
constexpr double kTrialPart = 0.05;
constexpr double kSecondTrialPart = 0.25;
/// A pixel: more than any scene's noise asks for.
constexpr std::uint32_t kMostSamples = 1U << 20U;

/// Errors fall by this power of the samples.
double slope_between(double few_samples, double few_rms, double samples, double rms) {
    if (!(few_rms > 0) || !(rms > 0) || few_samples <= 0) return 0.5;
    return std::clamp(math::log(few_rms / rms) / math::log(samples / few_samples), 0.4, 1.5);
}

}  // namespace

std::optional<BudgetChoice> choose_for_budget(const ir::Scene& scene, const Settings& settings,
                                              double seconds, Scheduler& scheduler,
                                              const Interrupted& interrupted) {
    const Clock::time_point begin = Clock::now();
    const auto left = [&] {
        return seconds - std::chrono::duration<double>(Clock::now() - begin).count();
    };
    Settings trial = settings;
    trial.samples = settings.scrambles;
    double few_samples = 0;
    double few_rms = 0;
    double slope = 0.5;
    std::optional<Run> last;
    while (true) {
        last = run(scene, trial, scheduler, interrupted);
        if (!last) return std::nullopt;
        const double rms = last->stats.achieved ? last->stats.achieved->rms : 0;
        if (few_samples > 0) slope = slope_between(few_samples, few_rms, trial.samples, rms);
        // The next trial takes four times as long.
        const double part = few_samples > 0 ? kTrialPart : kSecondTrialPart;
        if (last->render_seconds * 4 > part * seconds || trial.samples > kMostSamples / 8) break;
        few_samples = trial.samples;
        few_rms = rms;
        trial.samples *= 4;
    }
    const double of_one = last->render_seconds / trial.samples;
    const double usable = kUsable * left() - last->prepare_seconds;
    const double affordable = of_one > 0 ? usable / of_one : kMostSamples;
    BudgetChoice choice;
    choice.fits = affordable >= settings.scrambles;
    const double rounds = std::floor(
        std::clamp(affordable, 1.0 * settings.scrambles, 1.0 * kMostSamples) / settings.scrambles);
    choice.samples = static_cast<std::uint32_t>(rounds) * settings.scrambles;
    choice.seconds = last->prepare_seconds + of_one * choice.samples;
    const double rms = last->stats.achieved ? last->stats.achieved->rms : 0;
    choice.rms = rms * math::pow(static_cast<double>(choice.samples) / trial.samples, -slope);
    return choice;
}

}  // namespace cobble::renderer
