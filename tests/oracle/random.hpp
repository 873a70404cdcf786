// SPDX-License-Identifier: MIT
// Numbers, points and directions for tests, the same everywhere.
#pragma once

#include <cmath>
#include <cstdint>

#include "ir/math/elementary.hpp"
#include "ir/math/vec.hpp"
#include "tests/support/split_mix.hpp"

namespace cobble::test {

class Random : public SplitMix64 {
  public:
    using SplitMix64::SplitMix64;
    std::uint32_t below(std::uint32_t n) {
        return static_cast<std::uint32_t>(SplitMix64::below(n));
    }
    /// In [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double in(double lo, double hi) { return lo + unit() * (hi - lo); }
    math::Vec3d point(double half_side) {
        const double x = in(-half_side, half_side);
        const double y = in(-half_side, half_side);
        const double z = in(-half_side, half_side);
        return {x, y, z};
    }
    /// A unit vector, all directions alike.
    math::Vec3d direction() {
        const double z = in(-1, 1);
        const math::SinCos a = math::sincos(in(0, 2 * math::kPi));
        const double r = std::sqrt(1 - z * z);
        return {r * a.cos, r * a.sin, z};
    }
};

}  // namespace cobble::test
