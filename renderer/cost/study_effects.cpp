// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "renderer/cost/parts.hpp"
#include "renderer/estimate/student.hpp"

namespace cobble::renderer {
namespace {

constexpr std::uint32_t kFewestRuns = 3;
constexpr std::uint32_t kMostRuns = 12;

/// The mean of differences, with its interval by Student's t.
void set_seconds(const std::vector<double>& differences, EffectBill& bill) {
    const auto n = static_cast<double>(differences.size());
    double sum = 0;
    for (const double difference : differences) sum += difference;
    bill.seconds = sum / n;
    double squares = 0;
    for (const double difference : differences) {
        squares += (difference - bill.seconds) * (difference - bill.seconds);
    }
    const auto freedom = static_cast<std::uint32_t>(differences.size() - 1);
    const double reach = student_quantile(0.05, freedom) * std::sqrt(squares / (n * (n - 1)));
    bill.seconds_band = {bill.seconds - reach, bill.seconds + reach};
}

}  // namespace

std::optional<EffectsStudy> study_effects(const Studio& studio, std::uint32_t samples,
                                          double until) {
    const Settings settings = studio.settings(samples);
    EffectsStudy study;
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        if (settings.effects.states[i].on) {
            study.bills.emplace_back().effect = static_cast<ir::Effect>(i);
        }
    }
    if (study.bills.empty()) return study;
    std::vector<std::vector<double>> saved(study.bills.size());
    double seconds = 0;
    while (study.runs < kFewestRuns || (study.runs < kMostRuns && studio.before(until))) {
        const std::optional<Run> with = studio.run(settings);
        if (!with) return std::nullopt;
        seconds += with->seconds();
        for (std::size_t i = 0; i < study.bills.size(); ++i) {
            EffectBill& bill = study.bills[i];
            Settings without = settings;
            without.effects.states[static_cast<std::size_t>(bill.effect)].on = false;
            const std::optional<Run> run = studio.run(without);
            if (!run) return std::nullopt;
            saved[i].push_back(with->seconds() - run->seconds());
            if (study.runs > 0) continue;
            bill.rays = static_cast<std::int64_t>(with->stats.counters.rays()) -
                        static_cast<std::int64_t>(run->stats.counters.rays());
            const Distance loss = distance(studio, with->picture.color, run->picture.color);
            bill.rmse = loss.rmse;
            bill.flip = loss.flip;
            bill.maximum = loss.maximum;
        }
        ++study.runs;
    }
    for (std::size_t i = 0; i < study.bills.size(); ++i) {
        set_seconds(saved[i], study.bills[i]);
        study.bills[i].share = study.bills[i].seconds * study.runs / seconds;
    }
    return study;
}

}  // namespace cobble::renderer
