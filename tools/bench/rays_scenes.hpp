// SPDX-License-Identifier: MIT
// Scenes to shoot rays at, and random numbers to aim them with: the same each time.
#pragma once

#include <cstdint>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::bench {

/// A bumpy sphere around the origin, of 2 n (n - 1) triangles.
ir::Scene mesh_scene(std::uint32_t n);

/// n spheres in the ball of radius 1.
ir::Scene sphere_scene(std::uint32_t n);

/// In [0, 1); `state` is any number, and moves on.
double next_unit(std::uint64_t& state);

/// Of length 1, evenly over the sphere.
math::Vec3d next_direction(std::uint64_t& state);

}  // namespace cobble::bench
