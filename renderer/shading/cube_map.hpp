// SPDX-License-Identifier: MIT
// Six pictures around everything: which face and texel a direction finds.
#pragma once

#include <array>
#include <cstdint>

#include "ir/math/vec.hpp"
#include "ir/scene/assets.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::renderer {

/// A place on a cube map. u runs rightwards and v upwards in the face's picture, both in [0, 1].
struct CubePoint {
    ir::CubeMap::Face face = ir::CubeMap::kFront;
    double u = 0.5, v = 0.5;
};

/// The face that a direction (of any length) meets: its largest component by magnitude, x before y
/// before z where they tie. With a = |largest component|: right (+x) u = z/a, left (-x) u = -z/a,
/// up (+y) and down (-y) u = x/a, front (+z) u = -x/a, back (-z) u = x/a; v = y/a but for up, z/a,
/// and down, -z/a; each then (1 + .) / 2. These are the published programs' faces, checked on
/// published maps: only so do the pictures fit along all twelve edges. A zero or NaN direction
/// gives the middle of the front.
CubePoint cube_point(math::Vec3d direction);

/// Bilinear between texel centres, across edges too: a texel beyond an edge is the one next to it
/// on the neighbouring face, and the one missing beyond a corner is the mean of the three that
/// meet there. So the colour is continuous over the whole sphere. Faces are square, equal in size
/// and complete; if any of them is missing, kErrorColor.
ir::Color sample_cube_map(const ir::Scene& scene, const ir::CubeMap& map, ir::TextureFilter filter,
                          math::Vec3d direction);

}  // namespace cobble::renderer
