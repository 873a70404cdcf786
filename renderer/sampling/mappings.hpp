// SPDX-License-Identifier: MIT
// From the unit square to the shapes that effects sample. All keep area, so that stratified points
// stay stratified; all are continuous except where a polygon's triangles meet.
#pragma once

#include <cstdint>

#include "ir/math/vec.hpp"
#include "renderer/sampling/sobol.hpp"
#include "renderer/settings.hpp"

namespace cobble::renderer {

/// Uniform in the unit disk, by Shirley and Chiu's concentric squares (JGT 2(3), 1997).
math::Vec2d sample_disk(Uniform2 u);

/// Uniform in the regular polygon of `sides` (3 or more) corners on the unit circle, one of them at
/// the top.
math::Vec2d sample_polygon(Uniform2 u, std::uint32_t sides);

/// A direction around +z, uniform in solid angle within `half_angle` of it: (x, y, z). At half
/// angle 0 it is 0 0 1 to the bit.
math::Vec3d sample_cone(Uniform2 u, double one_minus_cos_half_angle);

/// Offset from the pixel's centre, in pixels, distributed as the filter: box (one pixel wide), tent
/// (two wide), Gaussian (standard deviation 0.5, cut at radius 1.5).
math::Vec2d sample_filter(Uniform2 u, PixelFilter filter);

}  // namespace cobble::renderer
