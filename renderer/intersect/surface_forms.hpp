// SPDX-License-Identifier: MIT
// The arithmetic of surface points, shape by shape, and of rays that leave them: inline and without
// branches where it matters, so that it reads the same for one hit and in a loop over many.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "ir/math/vec.hpp"
#include "renderer/geometry/hit.hpp"
#include "renderer/geometry/primitives.hpp"
#include "renderer/geometry/ray.hpp"
#include "renderer/geometry/wide.hpp"

namespace cobble::renderer {

inline math::Vec3d to_double(math::Vec3<double> a) { return a; }
inline math::Vec3d to_double(math::Vec3<math::DoubleDouble> a) { return a.to<double>(); }

/// Unit length, for vectors of any size: scaled by a power of two first, so that no square leaves
/// the range. A zero vector stays zero.
inline math::Vec3d unit(math::Vec3d a) {
    const double x = std::fabs(a.x);
    const double y = std::fabs(a.y);
    const double z = std::fabs(a.z);
    const double xy = x > y ? x : y;
    const double most = xy > z ? xy : z;
    const double scale = most > 0x1p400 ? 0x1p-600 : most < 0x1p-400 ? 0x1p600 : 1.0;
    return normalize(a * scale);
}

/// A place on a ray.
template <typename T>
math::Vec3<Wide<T>> along(math::Vec3<T> origin, math::Vec3<T> direction, T t) {
    return widen(origin) + widen(direction) * Wide<T>(t);
}

/// With b1 and b2 the weights of b and c.
template <typename W>
math::Vec3<W> triangle_point(math::Vec3<W> a, math::Vec3<W> b, math::Vec3<W> c, W b1, W b2) {
    const W b0 = (W(1) - b1) - b2;
    return (a * b0 + b * b1) + c * b2;
}

/// Of any length.
template <typename T>
math::Vec3d triangle_normal(math::Vec3<T> a, math::Vec3<T> b, math::Vec3<T> c) {
    return to_double(cross(widen(b) - widen(a), widen(c) - widen(a)));
}

/// The unit normal of a sphere below a point near it, which is not its centre.
template <typename W>
math::Vec3<W> sphere_normal(math::Vec3<W> center, math::Vec3<W> near) {
    const math::Vec3<W> away = near - center;
    return away / wide_sqrt(dot(away, away));
}

/// The place of a box's face nearest to a point near it; the face is the one with this normal.
template <typename T>
math::Vec3<Wide<T>> box_point(const BoxBounds<T>& box, math::Vec3d normal,
                              math::Vec3<Wide<T>> near) {
    const auto on_axis = [](T low, T high, double outward, Wide<T> p) {
        const Wide<T> lo(low);
        const Wide<T> hi(high);
        const Wide<T> above = p < lo ? lo : p;
        const Wide<T> inside = above > hi ? hi : above;
        const Wide<T> below = outward < 0 ? lo : inside;
        return outward > 0 ? hi : below;
    };
    return {on_axis(box.lo.x, box.hi.x, normal.x, near.x),
            on_axis(box.lo.y, box.hi.y, normal.y, near.y),
            on_axis(box.lo.z, box.hi.z, normal.z, near.z)};
}

/// A sum of |n_i| b_i.
inline double along_normal(math::Vec3d n, math::Vec3d b) {
    return (std::fabs(n.x) * b.x + std::fabs(n.y) * b.y) + std::fabs(n.z) * b.z;
}

/// What rounding a position to T moves it by along a unit normal, at most.
template <typename T>
double rounding_error(math::Vec3d normal, math::Vec3d position) {
    return double{kRounding<T>} *
           along_normal(normal,
                        {std::fabs(position.x), std::fabs(position.y), std::fabs(position.z)});
}

/// Whether a direction points to the side of the geometric normal.
template <typename T>
bool goes_outward(math::Vec3<T> direction, math::Vec3<T> geometric_normal) {
    return dot(direction, geometric_normal) >= T(0);
}

/// Where a ray that leaves a surface starts: off it by one bound to reach the surface, one for the
/// rounding of the sum (it is as large as that of the position, or smaller), and a quarter so that
/// products of roundings do not matter.
template <typename T>
math::Vec3<T> start_off(math::Vec3<T> position, math::Vec3<T> geometric_normal, T error,
                        bool outward) {
    const T away = error * T(2.25);
    return position + geometric_normal * (outward ? away : -away);
}

/// A ray's direction and end.
template <typename T>
struct Way {
    math::Vec3<T> direction;
    T t_max = 0;
};

/// From a start to `target`, which is at t = 1. It ends before it by what t of a surface through
/// the target errs by: some roundings of 1, and those of the target's coordinates in units of the
/// way to it. A target as near as a rounding: any direction, and no length, for nothing can be in
/// between.
template <typename T>
Way<T> way_to(math::Vec3<T> origin, math::Vec3<T> target, math::Vec3<T> geometric_normal) {
    const math::Vec3<T> way = target - origin;
    const T x = std::fabs(way.x);
    const T y = std::fabs(way.y);
    const T z = std::fabs(way.z);
    const T xy = x > y ? x : y;
    const T largest = xy > z ? xy : z;
    const T sum = (std::fabs(target.x) + std::fabs(target.y)) + std::fabs(target.z);
    const T slack = std::numeric_limits<T>::epsilon() * (4 + sum / largest);
    const bool nowhere = way.x == T(0) && way.y == T(0) && way.z == T(0);
    const T t_max = slack < T(1) ? T(1) - slack : T(0);
    return {{nowhere ? geometric_normal.x : way.x, nowhere ? geometric_normal.y : way.y,
             nowhere ? geometric_normal.z : way.z},
            nowhere ? T(0) : t_max};
}

}  // namespace cobble::renderer
