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
    // The far end as slab_span() has it, to the bit: a box is met exactly where its own slab test
    // passes, so that no tree can lose it or find more.
    T widened = std::numeric_limits<T>::max();
    for (std::uint32_t i = 0; i < 3; ++i) {
        if (ray.parallel[i]) {
            if (!(box.lo[i] <= ray.origin[i] && ray.origin[i] <= box.hi[i])) return std::nullopt;
            continue;
        }
        const bool negative = ray.negative[i];
        const T a = ((negative ? box.hi[i] : box.lo[i]) - ray.origin[i]) * ray.inverse[i];
        const T way = (negative ? box.lo[i] : box.hi[i]) - ray.origin[i];
        const T b = way * ray.inverse[i];
        const T wide = way * ray.inverse_far[i];
        widened = wide < widened ? wide : widened;
        if (a > hit.near) {
            hit.near = a;
            hit.near_face = 2 * i + (negative ? 1 : 0);
        }
        if (b < hit.far) {
            hit.far = b;
            hit.far_face = 2 * i + (negative ? 0 : 1);
        }
    }
    if (!(hit.near <= widened)) return std::nullopt;
    // Along an edge the ends may have crossed by a rounding: t never lies before the slabs' begin.
    if (hit.far < hit.near) hit.far = hit.near;
    return hit;
}

}  // namespace cobble::renderer
