// SPDX-License-Identifier: MIT
// The state of moving things at a time: `a + f (b - a)`, number by number.
#pragma once

#include <array>

#include "renderer/geometry/motion.hpp"
#include "renderer/scene/geometry.hpp"

namespace cobble::renderer {

template <typename T>
std::array<math::Vec3<T>, 3> triangle_at(const Geometry<T>& geometry, const MovingPrimitive& moving,
                                         T time) {
    const auto at = segment_at(moving.keys, time);
    const auto& a = geometry.triangle_keys[moving.first + at.index];
    if (at.fraction == 0) return a;
    const auto& b = geometry.triangle_keys[moving.first + at.index + 1];
    return {lerp(a[0], b[0], at.fraction), lerp(a[1], b[1], at.fraction),
            lerp(a[2], b[2], at.fraction)};
}

template <typename T>
SphereKey<T> sphere_at(const Geometry<T>& geometry, const MovingPrimitive& moving, T time) {
    const auto at = segment_at(moving.keys, time);
    const auto& a = geometry.sphere_keys[moving.first + at.index];
    if (at.fraction == 0) return a;
    const auto& b = geometry.sphere_keys[moving.first + at.index + 1];
    return {lerp(a.center, b.center, at.fraction), math::lerp(a.radius, b.radius, at.fraction)};
}

template <typename T>
PlaneKey plane_at(const Geometry<T>& geometry, const MovingPrimitive& moving, T time) {
    const auto at = segment_at(moving.keys, time);
    const auto& a = geometry.plane_keys[moving.first + at.index];
    if (at.fraction == 0) return a;
    const auto& b = geometry.plane_keys[moving.first + at.index + 1];
    const double f{at.fraction};
    return {lerp(a.normal, b.normal, f), math::lerp(a.offset, b.offset, f)};
}

template <typename T>
math::Affine<T> world_to_object_at(const Geometry<T>& geometry, const Instance<T>& instance,
                                   T time) {
    const auto at = segment_at(instance.keys, time);
    const auto& a = geometry.instance_keys[instance.first_key + at.index].world_to_object;
    if (at.fraction == 0) return a;
    const auto& b = geometry.instance_keys[instance.first_key + at.index + 1].world_to_object;
    return lerp(a, b, at.fraction);
}

}  // namespace cobble::renderer
