// SPDX-License-Identifier: MIT
// Rays against axis-aligned boxes as surfaces.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "renderer/geometry/slab.hpp"

namespace cobble::renderer {

/// Where a line enters and leaves, and through which faces: 2 axis + (1 on the upper side), the
/// least where it meets an edge or a corner.
template <typename T>
struct BoxHit {
    T near, far;
    std::uint32_t near_face, far_face;
};

template <typename T>
std::optional<BoxHit<T>> intersect_box(const RaySlabs<T>& ray, const BoxBounds<T>& box) {
    BoxHit<T> hit{std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max(), 0, 0};
    for (std::uint32_t i = 0; i < 3; ++i) {
        if (ray.parallel[i]) {
            if (!(box.lo[i] <= ray.origin[i] && ray.origin[i] <= box.hi[i])) return std::nullopt;
            continue;
        }
        const bool negative = ray.negative[i];
        const T a = ((negative ? box.hi[i] : box.lo[i]) - ray.origin[i]) * ray.inverse[i];
        const T b = ((negative ? box.lo[i] : box.hi[i]) - ray.origin[i]) * ray.inverse[i];
        if (a > hit.near) {
            hit.near = a;
            hit.near_face = 2 * i + (negative ? 1 : 0);
        }
        if (b < hit.far) {
            hit.far = b;
            hit.far_face = 2 * i + (negative ? 0 : 1);
        }
    }
    if (!(hit.near <= hit.far * kFarSlack<T>)) return std::nullopt;
    // Along an edge the ends may have crossed by a rounding: t never lies before the slabs' begin.
    if (hit.far < hit.near) hit.far = hit.near;
    return hit;
}

}  // namespace cobble::renderer
