// SPDX-License-Identifier: MIT
// Numbers for choosing what to try: a hash of what they are for, so that no choice depends on
// another.
#pragma once

#include <cstdint>

#include "ir/math/elementary.hpp"
#include "ir/math/vec.hpp"
#include "renderer/sampling/hash.hpp"

namespace cobble::renderer {

class Choices {
  public:
    Choices(std::uint64_t what, std::uint64_t which) : key_(combine(what, which)) {}

    std::uint64_t bits() { return combine(key_, drawn_++); }
    /// In [0, 1), all multiples of 2^-53 alike.
    double unit() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
    /// Below n, n at least 1.
    std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(bits() % n); }
    /// A unit vector, all directions alike.
    math::Vec3d direction() {
        const double z = 2 * unit() - 1;
        const math::SinCos turn = math::sincos(2 * math::kPi * unit());
        const double r = std::sqrt(1 - z * z);
        return {r * turn.cos, r * turn.sin, z};
    }

  private:
    std::uint64_t key_;
    std::uint64_t drawn_ = 0;
};

}  // namespace cobble::renderer
