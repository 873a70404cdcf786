// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "renderer/cost/parts.hpp"

namespace cobble::renderer {
namespace {

/// Errors that people ask for, in display values: a picture without visible noise, a good one, a
/// fair one, a rough one.
constexpr std::array kTargets = {0.005, 0.01, 0.02, 0.05};

std::string seconds_text(double seconds) {
    if (seconds < 0.001) return "less than 1 ms";
    return seconds < 0.1 ? fmt::format("{:.0f} ms", seconds * 1000)
                         : fmt::format("{:.1f} s", seconds);
}

/// The quickest rung that is at least that exact; null if none is. With more light samples than
/// were asked about, or with just those; all else is as it was asked about.
const Rung* quickest_within(const CostReport& report, double error, bool more_light) {
    const Rung* best = nullptr;
    for (const Rung& rung : report.rungs) {
        const bool as_asked =
            rung.bounces == report.bounces && rung.precision == report.asked_precision &&
            more_light == (rung.light_samples > std::max(report.light_samples, 1U));
        if (rung.error > error || !as_asked) continue;
        if (best == nullptr || rung.seconds < best->seconds) best = &rung;
    }
    return best;
}

/// Whose fault the noise is, if it is anybody's.
std::string noise_text(const NoiseBill& noise) {
    const auto loudest =
        std::max_element(noise.shares.begin(), noise.shares.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
    if (loudest == noise.shares.end() || noise.shares.size() < 2) return {};
    if (noise.together > loudest->first) {
        return fmt::format("{:.0f} % of the noise is made by its sources together, {} in {:.0f} %",
                           100 * noise.together, loudest->name, 100 * loudest->total);
    }
    const std::string whose =
        loudest->name == "pixel" ? "where rays go through the pixel" : loudest->name;
    return fmt::format("{} makes {:.0f} % of the noise", whose, 100 * loudest->first);
}

}  // namespace

std::string recommend(const CostReport& report) {
    for (const double target : kTargets) {
        const Rung* const plain = quickest_within(report, target, false);
        if (plain == nullptr) continue;
        const std::string each =
            plain->light_samples > 1
                ? fmt::format(" with {} light samples each", plain->light_samples)
                : std::string();
        std::string text =
            fmt::format("{} samples{} reach an error of {:g} % in {}", plain->samples, each,
                        100 * target, seconds_text(plain->seconds));
        const std::string noise = noise_text(report.noise);
        if (!noise.empty()) text += "; " + noise;
        const Rung* const split = quickest_within(report, target, true);
        if (split != nullptr && split->seconds < 0.95 * plain->seconds) {
            text += fmt::format(": {} samples with {} light samples each reach it in {}",
                                split->samples, split->light_samples, seconds_text(split->seconds));
        }
        return text + ".";
    }
    const auto best =
        std::min_element(report.rungs.begin(), report.rungs.end(),
                         [](const Rung& a, const Rung& b) { return a.error < b.error; });
    if (best == report.rungs.end()) return {};
    return fmt::format(
        "The most exact choice that was tried, {} samples, is {:.2g} off after {}: give the study "
        "more time to see better ones.",
        best->samples, best->error, seconds_text(best->seconds));
}

}  // namespace cobble::renderer
