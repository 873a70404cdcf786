// SPDX-License-Identifier: MIT
// Normals bent by pictures: normal maps and bump maps.
#pragma once

#include "ir/math/vec.hpp"
#include "ir/scene/assets.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::renderer {

/// The normal that a map stores at `uv`, in its tangent frame, not unit: (c - 128) / 127 of each
/// 8-bit component, clamped to [-1, 1], so that 128 128 255 is 0 0 1 to the bit.
math::Vec3d mapped_normal(const ir::Image& image, ir::TextureFilter filter, math::Vec2d uv);

/// How steeply a height map rises along u and along v: 0.05 times the difference of heights one
/// texel to each side, over their distance in uv. The red channel is the height; 0 to 1 is 0.05 of
/// a repeat of the picture. A missing map is flat.
math::Vec2d bump_slope(const ir::Image& image, ir::TextureFilter filter, math::Vec2d uv);

/// `normal` bent by a tangent-space normal: 0 0 1 (or anything straight up) gives the bits of
/// `normal`. The tangents are how the surface moves with u and v, of any length; they are made
/// perpendicular to `normal` and to each other, keeping the handedness of the picture. Where they
/// cannot be (zero, or along the normal) any frame is taken.
template <typename T>
math::Vec3<T> bend_normal(math::Vec3<T> normal, math::Vec3<T> dp_du, math::Vec3<T> dp_dv,
                          math::Vec3d tangent_space);

}  // namespace cobble::renderer
