// SPDX-License-Identifier: MIT
// How large the numbers are that a primitive is made of.
#pragma once

#include <cstdint>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::renderer {

/// World units, times the rounding of a type a bound on how far narrowing to it moves the surface:
/// the largest sum of coordinates of a corner, local to `origin`, with the radius of a sphere, and
/// under a matrix what its entries magnify. Planes are not narrowed: 0.
double reach_of(const ir::Scene& scene, math::Vec3d origin, ir::ObjectId object,
                std::uint32_t face);

}  // namespace cobble::renderer
