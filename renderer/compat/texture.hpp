// SPDX-License-Identifier: MIT
// The published programs' look-up of pictures: no repeat, no half texel.
#pragma once

#include "ir/scene/scene.hpp"

namespace cobble::renderer {

/// Texel (i, j) lies at u = i / width, v = 1 - j / height; linear between the four around, each
/// index clamped to the picture. `nearest`: the texel before. A missing picture is a checker.
ir::Color compat_texture(const ir::Image& image, math::Vec2d uv, bool nearest);

/// The colour in `direction`; each face looked up by itself, so that seams show.
ir::Color compat_cube_map(const ir::Scene& scene, const ir::CubeMap& map, math::Vec3d direction);

}  // namespace cobble::renderer
