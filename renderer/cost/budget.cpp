// SPDX-License-Identifier: MIT
#include "renderer/cost/budget.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "ir/math/elementary.hpp"

namespace cobble::renderer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kUsable = 0.98;  ///< of what is left: clocks and neighbours are not exact
/// Trials of the whole picture end where the next one would take this part of the time.
constexpr double kTrialPart = 0.05;
/// No longer than this for either kind, in seconds: more would tell nothing more.
constexpr double kLongestTrial = 5;
/// The trial of a part of the picture that comes nearest to the choice takes this part of the time.
constexpr double kPartTrial = 0.08;
constexpr std::uint32_t kMostParts = 8;
/// Of a part: fewer tell too little of a whole picture.
constexpr std::uint64_t kFewestPixels = 4096;
/// Small, so that a part has some of everything.
constexpr std::uint32_t kPartTile = 16;
/// A pixel: more than any scene's noise asks for.
constexpr std::uint32_t kMostSamples = 1U << 20U;

/// What a trial told.
struct Trial {
    double samples = 0;
    double of_one = 0;  ///< seconds, of one sample of each pixel
    double rays = 0;    ///< of one sample of each pixel
    double rms = 0;
    double prepare_seconds = 0;
};

/// Errors fall by this power of the samples: 1/2 is plain chance, 3/2 the best of smooth pictures.
double slope_between(const Trial& few, const Trial& many) {
    if (!(few.rms > 0) || !(many.rms > 0) || few.samples >= many.samples) return 0.5;
    return std::clamp(math::log(few.rms / many.rms) / math::log(many.samples / few.samples), 0.4,
                      1.5);
}

class Chooser {
  public:
    Chooser(const ir::Scene& scene, const Settings& settings, double seconds, Scheduler& scheduler,
            const Interrupted& interrupted)
        : scene_(&scene),
          settings_(settings),
          seconds_(seconds),
          scheduler_(&scheduler),
          interrupted_(&interrupted) {
        settings_.time_stages = false;
    }

    std::optional<BudgetChoice> choose() {
        std::optional<Trial> few = try_with(settings_, settings_.scrambles);
        if (!few) return std::nullopt;
        std::optional<Trial> before;
        while (few->prepare_seconds + few->of_one * few->samples * 4 <
                   std::min(kTrialPart * seconds_, kLongestTrial) &&
               few->samples < kMostSamples / 8.0) {
            before = few;
            few = try_with(settings_, static_cast<std::uint32_t>(uneven_rounds(4 * few->samples)));
            if (!few) return std::nullopt;
        }
        const double slope = before ? slope_between(*before, *few) : 0.5;
        const double near = part_samples(*few);
        // Each trial prepares the scene anew.
        const bool worth_it =
            near >= 2 * few->samples && 2 * few->prepare_seconds < kPartTrial * seconds_;
        return worth_it ? choose_by_part(*few, near) : choice_of(*few, slope);
    }

  private:
    std::optional<Trial> try_with(Settings settings, std::uint32_t samples) const {
        settings.samples = samples;
        const std::optional<Run> made = run(*scene_, settings, *scheduler_, *interrupted_);
        if (!made) return std::nullopt;
        // Of a part, without what workers wait for its last tiles: a whole picture has more tiles.
        const double seconds = settings.time_stages ? made->stats.stages.sum() / made->stats.workers
                                                    : made->render_seconds;
        return Trial{1.0 * samples, seconds / samples,
                     static_cast<double>(made->stats.counters.rays()) / samples,
                     made->stats.achieved ? made->stats.achieved->rms : 0, made->prepare_seconds};
    }

    [[nodiscard]] std::uint32_t parts() const {
        const Crop window = window_of(settings_);
        const std::uint64_t pixels = std::uint64_t{window.x1 - window.x0} * (window.y1 - window.y0);
        return static_cast<std::uint32_t>(
            std::clamp<std::uint64_t>(pixels / kFewestPixels, 1, kMostParts));
    }

    /// Samples that a part of the picture can have for its share of the time, whole rounds.
    [[nodiscard]] double part_samples(const Trial& few) const {
        const double affordable =
            few.of_one > 0 ? std::min(kPartTrial * seconds_, kLongestTrial) * parts() / few.of_one
                           : kMostSamples;
        return uneven_rounds(std::min(affordable, samples_for(few) / 2));
    }

    /// The whole picture's time and error go on as those of a part of it do.
    std::optional<BudgetChoice> choose_by_part(const Trial& few, double near) const {
        Settings part = settings_;
        part.shard_count = parts();
        part.time_stages = true;
        part.tile_size = std::min(part.tile_size, kPartTile);
        const std::optional<Trial> part_few =
            try_with(part, static_cast<std::uint32_t>(few.samples));
        if (!part_few) return std::nullopt;
        const std::optional<Trial> part_near = try_with(part, static_cast<std::uint32_t>(near));
        if (!part_near) return std::nullopt;
        Trial whole = few;
        whole.samples = near;
        // By the ray: what a part takes for few samples is too short to be measured.
        if (part_near->rays > 0) whole.of_one = few.rays * part_near->of_one / part_near->rays;
        if (part_few->rms > 0) whole.rms *= part_near->rms / part_few->rms;
        return choice_of(whole, slope_between(*part_few, *part_near));
    }

    /// How many the time that is left allows.
    [[nodiscard]] double samples_for(const Trial& trial) const {
        const std::chrono::duration<double> spent = Clock::now() - begin_;
        const double usable = kUsable * (seconds_ - spent.count()) - trial.prepare_seconds;
        return trial.of_one > 0 ? std::min<double>(usable / trial.of_one, kMostSamples)
                                : kMostSamples;
    }

    [[nodiscard]] double whole_rounds(double samples) const {
        return std::floor(samples / settings_.scrambles) * settings_.scrambles;
    }

    /// An odd number of samples for each scramble. Powers of two are much more even than other
    /// numbers of Sobol' points, and tell of none but themselves.
    [[nodiscard]] double uneven_rounds(double samples) const {
        const double rounds = std::floor(samples / settings_.scrambles);
        return (std::fmod(rounds, 2) == 0 ? rounds - 1 : rounds) * settings_.scrambles;
    }

    [[nodiscard]] BudgetChoice choice_of(const Trial& trial, double slope) const {
        const double affordable = samples_for(trial);
        BudgetChoice choice;
        choice.fits = affordable >= settings_.scrambles;
        choice.samples = static_cast<std::uint32_t>(
            whole_rounds(std::max<double>(affordable, settings_.scrambles)));
        choice.seconds = trial.prepare_seconds + trial.of_one * choice.samples;
        choice.rms = trial.rms * math::pow(choice.samples / trial.samples, -slope);
        return choice;
    }

    const ir::Scene* scene_;
    Settings settings_;
    double seconds_;
    Scheduler* scheduler_;
    const Interrupted* interrupted_;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace

std::optional<BudgetChoice> choose_for_budget(const ir::Scene& scene, const Settings& settings,
                                              double seconds, Scheduler& scheduler,
                                              const Interrupted& interrupted) {
    return Chooser(scene, settings, seconds, scheduler, interrupted).choose();
}

}  // namespace cobble::renderer
