// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/cost/parts.hpp"

namespace cobble::renderer {
namespace {

struct Choice {
    std::uint32_t samples, light_samples, bounces;
    Precision precision;
    double expected_seconds;
};

/// By the time that they are expected to take. Doubling light samples costs less than doubling
/// samples, but how much less is what is to be found out: it is taken to cost as much.
std::vector<Choice> choices_of(const Studio& studio, const CurveStudy& curve) {
    const Settings& base = studio.settings();
    const bool soft = base.effects.on(ir::Effect::kSoftShadows);
    const bool goes_on =
        base.effects.on(ir::Effect::kReflection) || base.effects.on(ir::Effect::kRefraction);
    std::vector<Choice> choices;
    const auto add = [&](std::uint32_t samples, std::uint32_t light_samples, std::uint32_t bounces,
                         Precision precision) {
        const double seconds = curve.prepare_seconds + curve.sample_seconds * samples *
                                                           (1 + light_samples) /
                                                           (1 + base.light_samples);
        choices.push_back({samples, light_samples, bounces, precision, seconds});
    };
    for (std::uint32_t samples = 2; samples <= 1024; samples *= 2) {
        const std::uint32_t light = base.light_samples;
        add(samples, light, base.bounces, base.precision);
        if (soft && samples >= 4) add(samples, 4 * light, base.bounces, base.precision);
        if (goes_on && base.bounces >= 2 && samples >= 8) {
            add(samples, light, base.bounces / 2, base.precision);
        }
    }
    if (base.precision == Precision::kFloat)
        add(16, base.light_samples, base.bounces, Precision::kDouble);
    std::stable_sort(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) {
        return a.expected_seconds < b.expected_seconds;
    });
    return choices;
}

void mark_front(std::vector<Rung>& rungs) {
    for (Rung& rung : rungs) {
        rung.on_front = std::none_of(rungs.begin(), rungs.end(), [&](const Rung& other) {
            return other.seconds <= rung.seconds && other.error <= rung.error &&
                   (other.seconds < rung.seconds || other.error < rung.error);
        });
    }
}

/// The front's, from the quickest to the most exact.
void name_front(const Settings& asked, std::vector<Rung>& rungs) {
    std::vector<Rung*> front;
    for (Rung& rung : rungs) {
        if (rung.on_front) front.push_back(&rung);
    }
    std::sort(front.begin(), front.end(),
              [](const Rung* a, const Rung* b) { return a->seconds < b->seconds; });
    for (std::size_t i = 0; i < front.size(); ++i) {
        Rung& rung = *front[i];
        rung.name = std::to_string(rung.samples) + " spp";
        if (rung.light_samples > 1)
            rung.name += " x " + std::to_string(rung.light_samples) + " light";
        if (rung.bounces != asked.bounces) {
            rung.name += ", " + std::to_string(rung.bounces) + " bounces";
        }
        if (i == 0) rung.name += " (preview)";
        if (i + 1 == front.size() && i > 0) rung.name += " (final)";
    }
}

/// Whether the same samples with all bounces came to just that: then there is nothing to bounce.
bool same_with_all_bounces(const std::vector<Rung>& rungs, const Choice& choice,
                           const Distance& off) {
    return std::any_of(rungs.begin(), rungs.end(), [&](const Rung& rung) {
        return rung.samples == choice.samples && rung.bounces > choice.bounces &&
               rung.precision == choice.precision && rung.error == off.rmse;
    });
}

Plane32 difference_map(const Plane32& a, const Plane32& b) {
    Plane32 map;
    map.width = a.width;
    map.height = a.height;
    map.channels = 1;
    map.values.resize(a.values.size() / 3);
    for (std::size_t i = 0; i < map.values.size(); ++i) {
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            map.values[i] = std::max(map.values[i], std::fabs(a.values[c] - b.values[c]));
        }
    }
    return map;
}

/// Until when all choices are tried; what is left of the time is for the front's second runs.
constexpr double kTriedPart = 0.6;
/// Of all the time: second runs that are no longer are made even when it is over.
constexpr double kShortPart = 0.01;

Settings settings_of(const Studio& studio, const Rung& rung) {
    Settings settings = studio.settings(rung.samples);
    settings.light_samples = std::max(rung.light_samples, 1U);
    settings.bounces = rung.bounces;
    settings.precision = rung.precision;
    return settings;
}

/// Runs those of the front once more with other random numbers, while there is time: a choice that
/// was merely lucky is not found so twice, and may make place for another. False if interrupted.
bool verify_front(const Studio& studio, const CurveStudy& curve, double until,
                  std::vector<Rung>& rungs) {
    const auto due = [&](const Rung& rung) {
        const double seconds = studio.options().seconds;
        const bool affordable = studio.seconds() + rung.seconds < until * seconds ||
                                rung.seconds < kShortPart * seconds;
        return rung.on_front && !rung.verified && affordable;
    };
    mark_front(rungs);
    for (auto at = std::find_if(rungs.begin(), rungs.end(), due); at != rungs.end();
         at = std::find_if(rungs.begin(), rungs.end(), due)) {
        Rung& rung = *at;
        Settings settings = settings_of(studio, rung);
        ++settings.seed;
        const std::optional<Run> run = studio.run(settings);
        if (!run) return false;
        const Distance off = distance(studio, curve.best.color, run->picture.color);
        rung.seconds = (rung.seconds + run->seconds()) / 2;
        rung.error = std::sqrt((rung.error * rung.error + off.rmse * off.rmse) / 2);
        rung.flip = (rung.flip + off.flip) / 2;
        rung.verified = true;
        mark_front(rungs);
    }
    return true;
}

}  // namespace

std::optional<std::vector<Rung>> study_rungs(const Studio& studio, const CurveStudy& curve,
                                             double until) {
    const bool soft = studio.settings().effects.on(ir::Effect::kSoftShadows);
    const double begin = studio.seconds();
    const double tried_until = begin + kTriedPart * (until * studio.options().seconds - begin);
    bool bounces_matter = true;
    std::vector<Rung> rungs;
    for (const Choice& choice : choices_of(studio, curve)) {
        if (rungs.size() >= 3 && studio.seconds() + choice.expected_seconds > tried_until) continue;
        if (choice.bounces < studio.settings().bounces && !bounces_matter) continue;
        Rung rung;
        rung.samples = choice.samples;
        rung.light_samples = soft ? choice.light_samples : 0;
        rung.bounces = choice.bounces;
        rung.precision = choice.precision;
        std::optional<Run> run = studio.run(settings_of(studio, rung));
        if (!run) return std::nullopt;
        const Distance off = distance(studio, curve.best.color, run->picture.color);
        if (choice.bounces < studio.settings().bounces &&
            same_with_all_bounces(rungs, choice, off)) {
            bounces_matter = false;
            continue;
        }
        // Where the best picture's own noise is as large, nothing can be told any more.
        if (off.rmse < 2 * curve.best_rms && rungs.size() >= 3) continue;
        rung.seconds = run->seconds();
        rung.error = off.rmse;
        rung.flip = off.flip;
        if (studio.options().keep_pictures) {
            rung.error_map = difference_map(run->picture.color, curve.best.color);
            rung.picture = std::move(run->picture.color);
        }
        rungs.push_back(std::move(rung));
    }
    if (!verify_front(studio, curve, until, rungs)) return std::nullopt;
    name_front(studio.settings(), rungs);
    // Pictures of choices that nobody should take are of no use.
    for (Rung& rung : rungs) {
        if (rung.on_front) continue;
        rung.picture = {};
        rung.error_map = {};
    }
    return rungs;
}

}  // namespace cobble::renderer
