// SPDX-License-Identifier: MIT
// Rays, and which surface a ray has just left.
#pragma once

#include <cstddef>
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

/// Many rays, number by number: each pointer leads to one number of each of them. They start at 0.
template <typename T>
struct RayColumns {
    const T* origin[3] = {};
    const T* direction[3] = {};
    bool one_origin = false;   ///< all origins are the same
    const T* t_max = nullptr;  ///< null: none ends
    const T* time = nullptr;
    /// What each leaves out, as Exclude has it; null: nothing.
    const std::uint32_t* object = nullptr;
    const std::uint32_t* face = nullptr;
    const std::int32_t* outward = nullptr;  ///< 0: goes inside

    [[nodiscard]] Ray<T> ray(std::size_t i) const {
        Ray<T> ray;
        ray.origin = {origin[0][i], origin[1][i], origin[2][i]};
        ray.direction = {direction[0][i], direction[1][i], direction[2][i]};
        if (t_max != nullptr) ray.t_max = t_max[i];
        ray.time = time[i];
        return ray;
    }
    [[nodiscard]] Exclude exclude(std::size_t i) const {
        if (object == nullptr) return {};
        return {ir::ObjectId{object[i]}, face[i], outward[i] == 0};
    }
    /// Those from `first` on.
    [[nodiscard]] RayColumns from(std::size_t first) const {
        RayColumns rest = *this;
        for (std::size_t a = 0; a < 3; ++a) {
            rest.origin[a] += first;
            rest.direction[a] += first;
        }
        if (t_max != nullptr) rest.t_max += first;
        rest.time += first;
        if (object != nullptr) {
            rest.object += first;
            rest.face += first;
            rest.outward += first;
        }
        return rest;
    }
};

}  // namespace cobble::renderer
