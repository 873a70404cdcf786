// SPDX-License-Identifier: MIT
// Rays, and which surface a ray has just left.
#pragma once

#include <cstdint>
#include <limits>

#include "ir/math/vec.hpp"
#include "ir/scene/ids.hpp"

namespace cobble::renderer {

/// The points origin + t direction with t_min < t < t_max, both ends excluded. Coordinates are
/// local: world minus PreparedScene::origin. The direction may have any length but zero; t counts
/// in its lengths. Nothing is NaN; t_max may be infinite.
template <typename T>
struct Ray {
    math::Vec3<T> origin;
    math::Vec3<T> direction;
    T t_min = 0;  ///< not below 0: far ends of spans are widened by multiplying
    T t_max = std::numeric_limits<T>::infinity();
    T time = 0;  ///< of the shutter, 0 to 1; only moving things look at it
};

/// What a ray must not hit because it starts there. A flat primitive (triangle, plane) is left out
/// altogether; of a closed one (sphere, box) only the far side counts, and only for a ray that goes
/// inside.
struct Exclude {
    ir::ObjectId object;  ///< invalid: nothing is left out
    std::uint32_t face = 0;
    bool goes_inside = false;  ///< against the geometric normal
};

}  // namespace cobble::renderer
