// SPDX-License-Identifier: MIT
// Rays against axis-aligned boxes, conservatively: Ize, Robust BVH Ray Traversal (JCGT 2, 2013).
//
// (bound - origin) * inverse is monotone in the bound under rounding, and so is the widening of the
// far end: a box inside another spans no more of a ray than the other, to the last bit.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "ir/math/vec.hpp"
#include "renderer/geometry/primitives.hpp"

namespace cobble::renderer {

/// Ize's widening of the far end by 2 gamma(3), with one rounding more because it is multiplied
/// into the inverse: gamma(3) + gamma(4) is a little above 3.5 epsilon.
template <typename T>
inline constexpr T kFarSlack = 1 + 4 * std::numeric_limits<T>::epsilon();

/// What the slab test needs of a ray, once per ray.
template <typename T>
struct RaySlabs {
    math::Vec3<T> origin;
    math::Vec3<T> inverse;      ///< of the direction; 0 along a parallel axis
    math::Vec3<T> inverse_far;  ///< times kFarSlack
    bool negative[3];
    /// The direction's component is 0, or so small that its inverse is infinite, or would be once
    /// it is widened: the box's own extent decides, by comparison with the origin, never by 0 times
    /// infinity.
    bool parallel[3];
    bool any_parallel = false;

    RaySlabs(math::Vec3<T> from, math::Vec3<T> direction) : origin(from) {
        for (std::size_t i = 0; i < 3; ++i) {
            const T inv = 1 / direction[i];
            parallel[i] = !(std::fabs(inv * kFarSlack<T>) <= std::numeric_limits<T>::max());
            inverse[i] = parallel[i] ? T(0) : inv;
            inverse_far[i] = inverse[i] * kFarSlack<T>;
            negative[i] = !parallel[i] && inv < 0;
            any_parallel = any_parallel || parallel[i];
        }
    }

    /// With what another of these has computed, of a ray that is parallel to no axis.
    RaySlabs(math::Vec3<T> from, math::Vec3<T> inverses, math::Vec3<T> far_inverses)
        : origin(from), inverse(inverses), inverse_far(far_inverses) {
        for (std::size_t i = 0; i < 3; ++i) {
            negative[i] = inverse[i] < 0;
            parallel[i] = false;
        }
    }
};

/// The part of a ray inside a box, not clipped by where the ray starts or ends; empty if !(near <=
/// far).
template <typename T>
struct Span {
    T near, far;
    [[nodiscard]] bool empty() const { return !(near <= far); }
};

template <typename T>
Span<T> slab_span(const RaySlabs<T>& ray, const BoxBounds<T>& box) {
    Span<T> span{std::numeric_limits<T>::lowest(), std::numeric_limits<T>::max()};
    for (std::size_t i = 0; i < 3; ++i) {
        if (ray.parallel[i]) {
            if (!(box.lo[i] <= ray.origin[i] && ray.origin[i] <= box.hi[i])) return {1, 0};
            continue;
        }
        const T a = ((ray.negative[i] ? box.hi[i] : box.lo[i]) - ray.origin[i]) * ray.inverse[i];
        const T b =
            ((ray.negative[i] ? box.lo[i] : box.hi[i]) - ray.origin[i]) * ray.inverse_far[i];
        span.near = a > span.near ? a : span.near;
        span.far = b < span.far ? b : span.far;
    }
    return span;
}

}  // namespace cobble::renderer
