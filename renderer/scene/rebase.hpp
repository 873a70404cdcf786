// SPDX-License-Identifier: MIT
// Maps between coordinates that are relative to one origin and to another.
#pragma once

#include "ir/math/affine.hpp"
#include "ir/math/box_bounds.hpp"
#include "ir/math/vec.hpp"

namespace cobble::renderer {

using math::grid_origin;

/// `map` for points given relative to `from`, with results relative to `to`: to the last bit of
/// the sums.
math::Affined rebased(const math::Affined& map, math::Vec3d from, math::Vec3d to);

}  // namespace cobble::renderer
