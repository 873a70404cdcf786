// SPDX-License-Identifier: MIT
// What the surface-area heuristic weighs boxes by.
#pragma once

#include "renderer/geometry/primitives.hpp"

namespace cobble::renderer {

/// Half the surface; 0 for an empty box. In double: a float's square may overflow.
template <typename T>
double half_area(const BoxBounds<T>& b) {
    if (b.empty()) return 0;
    const double x = double{b.hi.x} - double{b.lo.x};
    const double y = double{b.hi.y} - double{b.lo.y};
    const double z = double{b.hi.z} - double{b.lo.z};
    return (x * y + y * z) + z * x;
}

}  // namespace cobble::renderer
