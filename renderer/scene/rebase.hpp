// SPDX-License-Identifier: MIT
// The origin that coordinates are made relative to before they are narrowed.
#pragma once

#include "ir/math/affine.hpp"
#include "ir/math/vec.hpp"
#include "renderer/geometry/primitives.hpp"

namespace cobble::renderer {

/// The point of the grid nearest to where `box` comes closest to `anchor`. Grid lines are a power
/// of two apart that is at least the box's longest side: a thing around zero keeps its coordinates,
/// one far away is brought near, and moving everything by whole steps changes no bit. An empty box
/// (planes only) takes steps of 1024.
math::Vec3d grid_origin(const BoxBounds<double>& box, math::Vec3d anchor);

/// `map` for points given relative to `from`, with results relative to `to`: to the last bit of
/// the sums.
math::Affined rebased(const math::Affined& map, math::Vec3d from, math::Vec3d to);

}  // namespace cobble::renderer
