// SPDX-License-Identifier: MIT
// A ray and what it met. Private to this folder.
#pragma once

#include <limits>

#include "renderer/geometry/hit.hpp"
#include "renderer/geometry/ray.hpp"

namespace cobble::renderer {

template <typename T>
struct Seen {
    Ray<T> ray;
    Hit<T> hit;
    SurfacePoint<T> point;  ///< if hit

    /// Infinite for nothing.
    [[nodiscard]] double t() const {
        return hit ? double{hit.t} : std::numeric_limits<double>::infinity();
    }
};

}  // namespace cobble::renderer
