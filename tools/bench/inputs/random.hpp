// SPDX-License-Identifier: MIT
// Random numbers and directions that are the same in every run.
#pragma once

#include <cmath>
#include <cstdint>

#include "ir/math/elementary.hpp"
#include "ir/math/vec.hpp"

namespace cobble::bench {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        // splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31);
    }
    /// In [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }

    /// Uniform over the unit sphere.
    math::Vec3d direction() {
        const double z = 2 * unit() - 1;
        const auto a = math::sincos(2 * math::kPi * unit());
        const double r = std::sqrt(1 - z * z);
        return {r * a.cos, r * a.sin, z};
    }

  private:
    std::uint64_t state_;
};

}  // namespace cobble::bench
