// SPDX-License-Identifier: MIT
// A scene that mixes everything, and rays that try everything.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/hard/scenes.hpp"

namespace cobble::test {

/// Everything that a scene can hold, at rest and moving, some of it in the same place; if asked,
/// but for boxes that are not placed.
ir::Scene mixed_scene(std::uint64_t seed, bool with_boxes = true);

/// Origins inside and outside; directions at random, along axes, diagonal, and almost along them.
template <typename T>
renderer::Ray<T> any_ray(Random& random) {
    renderer::Ray<T> r = ray<T>(random.point(8), random.direction());
    const auto kind = random.below(8);
    if (kind == 0) {
        const std::size_t axis = random.below(3);
        r.direction = {0, T(-0.0), 0};
        r.direction[axis] = random.below(2) == 0 ? T(1) : T(-1);
    }
    if (kind == 1) r.direction[random.below(3)] = 0;
    if (kind == 2) r.direction[random.below(3)] = std::numeric_limits<T>::denorm_min();
    if (kind == 3)
        r.origin = {std::floor(r.origin.x), std::floor(r.origin.y), std::floor(r.origin.z)};
    if (kind == 4) r.direction = r.direction * T(random.in(1e-3, 1e3));
    if (kind == 5) r.direction = {1, -1, random.below(2) == 0 ? T(1) : T(0)};
    r.time = static_cast<T>(random.unit());
    if (random.below(5) == 0) r.time = random.below(2) == 0 ? T(0) : T(1);
    if (random.below(4) == 0) r.t_max = static_cast<T>(random.in(1, 10));
    if (random.below(4) == 0) r.t_min = static_cast<T>(random.in(0, 3));
    return r;
}

}  // namespace cobble::test
