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

/// The least power of two that is at least the box's longest side; 1024 for an empty box (planes
/// only), infinite for one that is nearly as wide as double reaches.
double grid_step(const BoxBounds<double>& box);

/// The point of a grid whose lines are `step` apart; zero if there is no finite one.
Vec3d nearest_on_grid(Vec3d p, double step);

/// The point of the grid of grid_step() nearest to where `box` comes closest to `anchor`: a thing
/// around zero keeps its coordinates, one far away is brought near, and moving everything by whole
/// steps changes no bit.
Vec3d grid_origin(const BoxBounds<double>& box, Vec3d anchor);

}  // namespace cobble::math
