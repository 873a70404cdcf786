// SPDX-License-Identifier: MIT
// Numbers for tests, the same everywhere: splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
#pragma once

#include <cmath>
#include <cstdint>

#include "ir/math/elementary.hpp"
#include "ir/math/vec.hpp"

namespace cobble::test {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31);
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(bits() % n); }
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

  private:
    std::uint64_t state_;
};

}  // namespace cobble::test
