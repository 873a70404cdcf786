// SPDX-License-Identifier: MIT
// Rays against planes.
#pragma once

#include <optional>

#include "renderer/geometry/primitives.hpp"
#include "renderer/geometry/wide.hpp"

namespace cobble::renderer {

/// t of the crossing, of any sign; nothing for a ray along the plane. In twice the precision of T:
/// at grazing angles the numerator and the denominator both cancel.
template <typename T>
std::optional<T> intersect_plane(math::Vec3<T> origin, math::Vec3<T> direction,
                                 const PlaneKey& plane) {
    using W = Wide<T>;
    const math::Vec3<W> n = plane.normal.to<W>();
    const W along = dot(n, widen(direction));
    if (along == W(0)) return std::nullopt;
    return static_cast<T>((W(plane.offset) - dot(n, widen(origin))) / along);
}

}  // namespace cobble::renderer
