// SPDX-License-Identifier: MIT
// Directions in float that are the bits of normalize() in double, rounded once, without its root
// and its divisions: with a bound on how far off they may be, and a look at whether that matters.
#pragma once

#include <cmath>
#include <cstdint>

#include "ir/math/vec.hpp"

namespace cobble::renderer {

struct QuickUnit {
    math::Vec3<float> direction;
    std::uint32_t unsure = 0;  ///< 1: it may be others than normalize(a).to<float>()
};

/// Without branches, so that a loop takes many at once. Of 2^17 directions about one is unsure,
/// those far shorter or longer than 1 all are.
inline QuickUnit quick_unit(math::Vec3d a) {
    const double square = math::dot(a, a);
    // In float the inverse root is off by 2^-25 for the rounded square, 2^-24 each for root and
    // quotient: below 2^-22.6 of itself. Newton's step makes 3/2 e^2 of that, below 2^-44.6.
    const auto narrow = static_cast<float>(square);
    const double guess{1.0F / std::sqrt(narrow)};
    const double inverse = guess * (1.5 - (0.5 * square) * (guess * guess));
    // That, roundings of 2^-53 here and those of normalize(), with room. Rounding never turns two
    // numbers around: if both ends give one float, so does whatever is between them.
    constexpr double kOff = 0x1p-44;
    constexpr double kLeast = 1 - kOff;
    constexpr double kMost = 1 + kOff;
    const math::Vec3d direction = a * inverse;
    const math::Vec3<float> low = (direction * kLeast).to<float>();
    const math::Vec3<float> high = (direction * kMost).to<float>();
    // Where float has its full precision, roots and all.
    constexpr float kShort = 0x1p-100F;
    constexpr float kLong = 0x1p100F;
    const bool sure =
        low.x == high.x && low.y == high.y && low.z == high.z && narrow > kShort && narrow < kLong;
    return {low, sure ? 0U : 1U};
}

}  // namespace cobble::renderer
