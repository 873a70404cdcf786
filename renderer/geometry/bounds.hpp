// SPDX-License-Identifier: MIT
// The own box of each bounded shape: part of what a hit is, and what trees are built of.
#pragma once

#include <array>

#include "ir/math/vec.hpp"
#include "renderer/geometry/primitives.hpp"
#include "renderer/geometry/slab.hpp"

namespace cobble::renderer {

/// The smallest and greatest coordinates of a triangle: its own box.
template <typename T>
BoxBounds<T> bounds_of(const std::array<math::Vec3<T>, 3>& vertices) {
    BoxBounds<T> box;
    for (const auto& v : vertices) box.add(v);
    return box;
}

/// A box around a sphere: centre and radius added, and moved outward by 2 epsilon of their
/// magnitudes, where the sum's rounding and the product's can take back less than 1.
template <typename T>
BoxBounds<T> bounds_of(math::Vec3<T> center, T radius) {
    BoxBounds<T> box;
    for (std::size_t i = 0; i < 3; ++i) {
        const T pad = (std::fabs(center[i]) + radius) * (2 * std::numeric_limits<T>::epsilon());
        box.lo[i] = (center[i] - radius) - pad;
        box.hi[i] = (center[i] + radius) + pad;
    }
    return box;
}

}  // namespace cobble::renderer
