// SPDX-License-Identifier: MIT
// Axis-aligned extents, and the grid that coordinates are made local to.
#pragma once

#include <cstddef>
#include <limits>

#include "ir/math/vec.hpp"

namespace cobble::math {

/// An axis-aligned box; inside out (lo = inf, hi = -inf) if empty.
template <typename T>
struct BoxBounds {
    Vec3<T> lo{std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity(),
               std::numeric_limits<T>::infinity()};
    Vec3<T> hi{-std::numeric_limits<T>::infinity(), -std::numeric_limits<T>::infinity(),
               -std::numeric_limits<T>::infinity()};

    constexpr void add(Vec3<T> p) {
        for (std::size_t i = 0; i < 3; ++i) {
            lo[i] = p[i] < lo[i] ? p[i] : lo[i];
            hi[i] = p[i] > hi[i] ? p[i] : hi[i];
        }
    }
    constexpr void add(const BoxBounds& b) {
        for (std::size_t i = 0; i < 3; ++i) {
            lo[i] = b.lo[i] < lo[i] ? b.lo[i] : lo[i];
            hi[i] = b.hi[i] > hi[i] ? b.hi[i] : hi[i];
        }
    }
    [[nodiscard]] constexpr bool empty() const { return !(lo.x <= hi.x); }
    friend constexpr bool operator==(const BoxBounds&, const BoxBounds&) = default;
};

/// The point of the grid nearest to where `box` comes closest to `anchor`. Grid lines are a power
/// of two apart that is at least the box's longest side: a thing around zero keeps its coordinates,
/// one far away is brought near, and moving everything by whole steps changes no bit. An empty box
/// (planes only) takes steps of 1024.
Vec3d grid_origin(const BoxBounds<double>& box, Vec3d anchor);

}  // namespace cobble::math
