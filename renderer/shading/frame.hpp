// SPDX-License-Identifier: MIT
// Right-handed orthonormal frames around a direction.
#pragma once

#include <cmath>

#include "ir/math/vec.hpp"

namespace cobble::renderer {

template <typename T>
struct Frame {
    math::Vec3<T> x, y, z;

    [[nodiscard]] math::Vec3<T> to_world(math::Vec3<T> local) const {
        return x * local.x + y * local.y + z * local.z;
    }
};

/// Any frame with this unit z (Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1),
/// 2017): no branch, good to rounding everywhere, the pole at -z included.
template <typename T>
Frame<T> frame_around(math::Vec3<T> z) {
    const T sign = std::copysign(T(1), z.z);
    const T a = T(-1) / (sign + z.z);
    const T b = z.x * z.y * a;
    return {
        {T(1) + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

}  // namespace cobble::renderer
