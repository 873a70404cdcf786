// SPDX-License-Identifier: MIT
// When an adaptive render looks at its error, and how sure each look has to be.
#pragma once

#include <array>
#include <cstdint>

namespace cobble::renderer {

/// Probability that a pixel's interval may miss, over all looks at it.
inline constexpr double kMissProbability = 0.05;

/// That of look `look`, from 1. However many looks there are, all of them are below
/// kMissProbability together: the sum of 1/k^2 is pi^2 / 6.
constexpr double miss_probability(std::uint32_t look) {
    constexpr double kSixOverPiSquared = 0.6079271018540267;
    return kMissProbability * kSixOverPiSquared / (double{1} * look * look);
}

/// Looks at most: the samples of a pixel, doubled each time, are a 32-bit number.
inline constexpr std::uint32_t kMostLooks = 32;

}  // namespace cobble::renderer
