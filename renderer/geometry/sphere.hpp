// SPDX-License-Identifier: MIT
// Rays against spheres: Haines, Günther and Akenine-Möller, Precision Improvements for Ray/Sphere
// Intersection (Ray Tracing Gems, 2019, chapter 7), with the discriminant in twice the precision.
#pragma once

#include <cmath>
#include <optional>

#include "ir/math/vec.hpp"
#include "renderer/geometry/wide.hpp"

namespace cobble::renderer {

/// Where a line enters and leaves: near <= far, of any sign.
template <typename T>
struct Roots {
    T near, far;
};

/// The roots of a x^2 - 2 b x + c, a > 0, given d = (b^2 - a c) / a >= 0 without cancellation: the
/// larger in magnitude first, the other from their product (Press et al., Numerical Recipes, 5.6).
template <typename W>
Roots<W> stable_roots(W a, W b, W c, W d) {
    const W root = wide_sqrt(a * d);
    const W q = b < W(0) ? b - root : b + root;
    // q is 0 only if both roots are.
    const W first = q / a;
    const W second = q > W(0) || q < W(0) ? c / q : W(0);
    return first < second ? Roots<W>{first, second} : Roots<W>{second, first};
}

/// radius > 0. Nothing if the line misses. A line within a rounding of T of the silhouette may do
/// either; one that touches exactly hits.
template <typename T>
std::optional<Roots<T>> intersect_sphere(math::Vec3<T> origin, math::Vec3<T> direction,
                                         math::Vec3<T> center, T radius) {
    using W = Wide<T>;
    if constexpr (sizeof(T) == sizeof(double)) {
        // Far from it in plain double is far from it: 2^-40 is some 2^10 times the error.
        const math::Vec3<T> f = origin - center;
        const math::Vec3<T> l = f - direction * (dot(f, direction) / dot(direction, direction));
        if (dot(l, l) > radius * radius * (1 + 0x1p-40) + dot(f, f) * 0x1p-40) return std::nullopt;
    }
    const math::Vec3<W> f = widen(origin) - widen(center);
    const math::Vec3<W> d = widen(direction);
    const W r(radius);
    const W a = dot(d, d);
    const W b = -dot(f, d);
    const math::Vec3<W> l = f + d * (b / a);
    const W rest = r * r - dot(l, l);
    if (!(rest >= W(0))) return std::nullopt;
    const auto roots = stable_roots(a, b, dot(f, f) - r * r, rest);
    return Roots<T>{static_cast<T>(roots.near), static_cast<T>(roots.far)};
}

/// All real roots of a x^2 + b x + c for numbers of type T: the discriminant has no cancellation,
/// so that each root is right to 1 ulp in float (2 in double), a double root included. A vanishing
/// `a` leaves the line's one root (near = far). Nothing if there is none, or if every x is one.
template <typename T>
std::optional<Roots<T>> solve_quadratic(T a, T b, T c);

}  // namespace cobble::renderer
