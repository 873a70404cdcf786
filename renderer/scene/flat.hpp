// SPDX-License-Identifier: MIT
// Triangles that nothing can hit.
#pragma once

#include <array>

#include "ir/math/vec.hpp"
#include "renderer/geometry/wide.hpp"

namespace cobble::renderer {

/// The vertices are collinear, exactly.
template <typename T>
bool flat(const std::array<math::Vec3<T>, 3>& v) {
    using W = Wide<T>;
    const math::Vec3<W> n = cross(widen(v[1]) - widen(v[0]), widen(v[2]) - widen(v[0]));
    return n.x == W(0) && n.y == W(0) && n.z == W(0);
}

}  // namespace cobble::renderer
