// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "renderer/cost/parts.hpp"
#include "renderer/metrics/compare.hpp"

namespace cobble::renderer {
namespace {

/// Time is that of the quickest run: what disturbs a run only makes it slower.
constexpr int kRuns = 3;

/// The last run, with the least time of up to kRuns, fewer if time is short.
std::optional<Run> quickest(const Studio& studio, const Settings& settings, double until) {
    std::optional<Run> best;
    for (int i = 0; i < kRuns; ++i) {
        if (best && !studio.before(until)) break;
        std::optional<Run> run = studio.run(settings);
        if (!run) return std::nullopt;
        if (!best || run->seconds() < best->seconds()) best = std::move(run);
    }
    return best;
}

}  // namespace

Distance distance(const Studio& studio, const Plane32& a, const Plane32& b) {
    CompareOptions how;
    how.pixels_per_degree = studio.options().pixels_per_degree;
    how.light_a = how.light_b = studio.options().light;
    how.threads = 0;
    const Comparison difference = compare(a, b, how);
    return {std::sqrt(difference.mse), difference.flip, difference.maximum};
}

std::optional<std::vector<EffectBill>> study_effects(const Studio& studio, std::uint32_t samples,
                                                     double until) {
    const Settings settings = studio.settings(samples);
    const std::optional<Run> with = quickest(studio, settings, until);
    if (!with) return std::nullopt;
    std::vector<EffectBill> bills;
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        if (!settings.effects.states[i].on) continue;
        Settings without = settings;
        without.effects.states[i].on = false;
        const std::optional<Run> run = quickest(studio, without, until);
        if (!run) return std::nullopt;
        EffectBill& bill = bills.emplace_back();
        bill.effect = static_cast<ir::Effect>(i);
        const std::uint64_t rays = with->stats.counters.rays();
        bill.rays = rays - std::min(rays, run->stats.counters.rays());
        bill.seconds = with->seconds() - run->seconds();
        bill.share = bill.seconds / with->seconds();
        const Distance loss = distance(studio, with->picture.color, run->picture.color);
        bill.rmse = loss.rmse;
        bill.flip = loss.flip;
        bill.maximum = loss.maximum;
    }
    return bills;
}

}  // namespace cobble::renderer
