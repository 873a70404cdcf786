// SPDX-License-Identifier: MIT
#include "renderer/passes/adaptive_forecast.hpp"

#include <algorithm>

#include "ir/math/elementary.hpp"
#include "renderer/passes/adaptive_rounds.hpp"

namespace cobble::renderer {
namespace {

// Of widths, when samples double: by their power 1/2, as by plain chance, and by 3/2, which is the
// best that evenly spread samples of smooth pictures do.
constexpr double kSlowest = 0.70710678;
constexpr double kFastest = 0.35355339;
/// Found by what the scenes of scenes/ took.
constexpr double kOwnShare = 0.4;

double likely(double factor) { return std::clamp(factor, kFastest, kSlowest); }

/// By what widths fall when samples double, where more are needed.
double falling_factor(const std::vector<float>& before, const std::vector<float>& now,
                      double error) {
    double squares_before = 0;
    double squares_now = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        // By both: those that are wide now, or were, are partly so by chance.
        if (!(before[i] + now[i] > 2 * error)) continue;
        squares_before += double{before[i]} * before[i];
        squares_now += double{now[i]} * now[i];
    }
    return squares_before > 0 ? likely(math::pow(squares_now / squares_before, 0.5)) : kSlowest;
}

/// A pixel's own. Its two widths say little of how they go on, and yet those that fall slowly take
/// most of the samples: without a share of its own too few would be expected.
double factor_of(double before, double now, double of_all) {
    if (!(before > 0) || !(now > 0)) return of_all;
    return likely(of_all * math::pow(now / before / of_all, kOwnShare));
}

/// Samples of a pixel that is so wide at the first look.
double expected_of(double width, double factor, const ErrorGoal& goal) {
    std::uint32_t round = 1;
    while (width > goal.error && round < kMostLooks &&
           scramble_samples(round + 1, goal.most_samples) >
               scramble_samples(round, goal.most_samples)) {
        width *= factor * standard_errors(round + 1) / standard_errors(round);
        ++round;
    }
    return static_cast<double>(scramble_samples(round, goal.most_samples)) * kScrambles;
}

}  // namespace

void AdaptiveForecast::set_widths(const std::vector<float>& before, const std::vector<float>& now,
                                  const ErrorGoal& goal) {
    const double of_all = falling_factor(before, now, goal.error);
    pixels_ = 0;
    samples_ = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (now[i] < 0) continue;
        pixels_ += 1;
        const bool wide = now[i] > goal.error;
        const double factor = wide ? factor_of(before[i], now[i], of_all) : 1;
        samples_ += expected_of(now[i], factor, goal);
    }
}

void AdaptiveForecast::set_costs(double seconds, double taken, double pass_seconds,
                                 double pass_samples) {
    const double left = std::max(samples_ - taken, 0.0);
    seconds_ = seconds + (pass_samples > 0 ? left * pass_seconds / pass_samples : 0);
}

std::optional<Forecast> AdaptiveForecast::forecast() const {
    if (pixels_ == 0 || seconds_ < 0) return std::nullopt;
    return Forecast{seconds_, samples_ / pixels_};
}

}  // namespace cobble::renderer
