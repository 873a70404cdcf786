// SPDX-License-Identifier: MIT
// Rays against triangles without cracks: Woop, Benthin and Wald, Watertight Ray/Triangle
// Intersection (JCGT 2, 2013).
//
// The vertices are sheared so that the ray runs along an axis; three edge functions say on which
// side it passes each edge. Plain products and differences round monotonically, so that a non-zero
// edge function of the sheared points has its exact sign, and two triangles that share an edge,
// which see the same two points, can not both miss. The points themselves are rounded, so that an
// edge that ends in the middle of another needs more: a triangle is refused only where two edge
// functions have opposite signs beyond all that they may err by, and what is too near to an edge to
// say so is decided in twice the precision (near_edge()). The t, u and v of what is accepted are
// computed in twice the precision and rounded once.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "ir/math/vec.hpp"
#include "renderer/geometry/wide.hpp"

namespace cobble::renderer {

namespace detail {

/// Below this an edge function may have lost bits to underflow (or be exactly zero, the case that
/// needs the exact sign): half way down the exponents of each type.
template <typename T>
inline constexpr T kEdgeThreshold = T(0x1p-100);
template <>
inline constexpr double kEdgeThreshold<double> = 0x1p-900;

}  // namespace detail

/// A ray's shear, once per ray.
template <typename T>
struct RayShear {
    math::Vec3<T> origin;
    math::Vec3<T> direction;
    std::size_t kx, ky, kz;  ///< kz: the axis that the direction follows most
    T sx, sy;

    RayShear(math::Vec3<T> from, math::Vec3<T> along) : origin(from), direction(along) {
        const math::Vec3<T> a{std::fabs(along.x), std::fabs(along.y), std::fabs(along.z)};
        kz = a.x > a.y ? (a.x > a.z ? 0U : 2U) : (a.y > a.z ? 1U : 2U);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        // Swapped where the ray runs backward, so that winding keeps its sense.
        if (along[kz] < 0) {
            const std::size_t k = kx;
            kx = ky;
            ky = k;
        }
        sx = slope(kx);
        sy = slope(ky);
    }

    /// With what another of these has computed: `x` and `y` are its sx and sy, 0 if they vanish.
    RayShear(math::Vec3<T> from, math::Vec3<T> along, std::size_t first, std::size_t second,
             std::size_t main, T x, T y)
        : origin(from), direction(along), kx(first), ky(second), kz(main), sx(x), sy(y) {
        if (sx == 0) direction[kx] = 0;
        if (sy == 0) direction[ky] = 0;
    }

  private:
    /// A slope that would vanish beside any coordinate is none: its products would underflow, and
    /// a triangle seen edge-on would be made of their rounding.
    T slope(std::size_t axis) {
        const T s = direction[axis] / direction[kz];
        if (std::fabs(s) >= detail::kEdgeThreshold<T>) return s;
        direction[axis] = 0;
        return 0;
    }
};

template <typename T>
struct TriangleHit {
    T t, u, v;  ///< u, v: weights of the second and the third vertex
};

/// Which crossings of an edge count.
enum class EdgeRule : std::uint8_t {
    kInclusive,  ///< an edge belongs to both its triangles: no cracks
    kHalfOpen,   ///< to exactly one of them: crossings can be counted
};

namespace detail {

template <typename T>
struct ShearedPoint {
    T x, y;
};

template <typename T>
ShearedPoint<T> shear(const RayShear<T>& ray, math::Vec3<T> relative) {
    return {relative[ray.kx] - ray.sx * relative[ray.kz],
            relative[ray.ky] - ray.sy * relative[ray.kz]};
}

/// p.x q.y - p.y q.x with its exact sign. Float products are exact in double.
inline double exact_edge(ShearedPoint<float> p, ShearedPoint<float> q) {
    return double{p.x} * q.y - double{p.y} * q.x;
}
/// Exact for points whose numbers are within 2^±440 (see common_scale()).
inline math::DoubleDouble exact_edge(ShearedPoint<double> p, ShearedPoint<double> q) {
    return math::two_product(p.x, q.y) - math::two_product(p.y, q.x);
}

template <typename W>
int sign_of(W value) {
    return value > W(0) ? 1 : value < W(0) ? -1 : 0;
}

/// The sign of a zero edge function, as if the ray were moved by (e, e^2) for a tiny e: opposite
/// for the edge run the other way, and one choice for all edges that meet in a point.
template <typename T>
int moved_sign(ShearedPoint<T> p, ShearedPoint<T> q) {
    if (p.y != q.y) return p.y > q.y ? 1 : -1;
    if (p.x != q.x) return p.x < q.x ? 1 : -1;
    return 0;
}

/// A common power of two for all sheared points: ratios do not change, and products neither
/// overflow nor underflow. Only double needs it.
inline float common_scale(const std::array<ShearedPoint<float>, 3>&) { return 1; }
double common_scale(const std::array<ShearedPoint<double>, 3>& points);

/// What is known of a hit once its weights are: t is where the ray meets the plane of the vertices;
/// their differences are not sheared, so that a sliver's t is as good as its plane.
template <typename T>
TriangleHit<T> met_at(const RayShear<T>& ray, const std::array<math::Vec3<T>, 3>& vertices,
                      const std::array<Wide<T>, 3>& weights, Wide<T> det) {
    using W = Wide<T>;
    const math::Vec3<W> p0 = widen(vertices[0]);
    const math::Vec3<W> normal = cross(widen(vertices[1]) - p0, widen(vertices[2]) - p0);
    const W along = dot(normal, widen(ray.direction));
    const auto& [u, v, w] = weights;
    W t;
    if (sign_of(along) != 0) {
        t = dot(normal, p0 - widen(ray.origin)) / along;
    } else {
        // Seen edge-on but for the rounding of the shear: the mean of the vertices' depths.
        const auto depth = [&](std::size_t i) {
            return W(vertices[i][ray.kz]) - W(ray.origin[ray.kz]);
        };
        t = ((u * depth(0) + v * depth(1)) + w * depth(2)) / (det * W(ray.direction[ray.kz]));
    }
    return TriangleHit<T>{static_cast<T>(t), static_cast<T>(v / det), static_cast<T>(w / det)};
}

/// What an edge function of sheared points may be off by. `size`: of the points, the sum of all six
/// magnitudes; `depth`: the vertices' farthest along the ray's axis; `unit`: half the distance from
/// 1 to the next number. A slope of at most 1 errs by 1 unit, so that a sheared number errs by 2
/// units of itself and 4 of its depth; two of them multiply with others of at most `size`. The rest
/// is for the squares of those errors, and for the roundings of this bound.
///
/// Multiplied in this order: where a product of an edge function overflows, so does the one of the
/// sizes, and the bound is infinite. An edge function that is infinite may be off by all of itself,
/// if its other product is as large.
template <typename R>
R edge_error(R unit, R size, R depth) {
    const R reach = size + 16 * unit * depth;
    return 8 * unit * (reach * (reach + depth));
}

template <typename T>
std::optional<TriangleHit<T>> triangle_in_wide(const RayShear<T>& ray,
                                               const std::array<math::Vec3<T>, 3>& vertices,
                                               std::array<ShearedPoint<T>, 3> points,
                                               EdgeRule rule) {
    using W = Wide<T>;
    const T scale = common_scale(points);
    for (auto& p : points) p = {p.x * scale, p.y * scale};
    const auto& [a, b, c] = points;
    const W u = exact_edge(c, b);
    const W v = exact_edge(a, c);
    const W w = exact_edge(b, a);
    int su = sign_of(u);
    int sv = sign_of(v);
    int sw = sign_of(w);
    if (rule == EdgeRule::kHalfOpen) {
        if (su == 0) su = moved_sign(c, b);
        if (sv == 0) sv = moved_sign(a, c);
        if (sw == 0) sw = moved_sign(b, a);
        if (su != sv || sv != sw || su == 0) return std::nullopt;
    } else if ((su < 0 || sv < 0 || sw < 0) && (su > 0 || sv > 0 || sw > 0)) {
        return std::nullopt;
    }
    const W det = (u + v) + w;
    if (sign_of(det) == 0) return std::nullopt;
    return met_at(ray, vertices, {u, v, w}, det);
}

/// For what triangle_in_wide() leaves out because a sheared point was rounded: points in a row need
/// not stay in a row, and where the end of an edge lies on another edge a ray could pass between
/// the two. The points are sheared anew in the wide type, and whatever is not surely outside is
/// inside: a line that meets the triangle is never lost, and one that misses it is refused but for
/// 2^-50 of the size of its surroundings. Nothing for a triangle that is seen edge-on.
template <typename T>
std::optional<TriangleHit<T>> near_edge(const RayShear<T>& ray,
                                        const std::array<math::Vec3<T>, 3>& vertices);

}  // namespace detail

/// The line of `ray` against a triangle, whatever the sign of t; nothing for a triangle without
/// area. `t` is not yet clamped to the triangle's box.
template <typename T>
std::optional<TriangleHit<T>> intersect_triangle(const RayShear<T>& ray,
                                                 const std::array<math::Vec3<T>, 3>& vertices,
                                                 EdgeRule rule = EdgeRule::kInclusive) {
    const math::Vec3<T> p = vertices[0] - ray.origin;
    const math::Vec3<T> q = vertices[1] - ray.origin;
    const math::Vec3<T> r = vertices[2] - ray.origin;
    const auto a = detail::shear(ray, p);
    const auto b = detail::shear(ray, q);
    const auto c = detail::shear(ray, r);
    const T depth = (std::fabs(p[ray.kz]) + std::fabs(q[ray.kz])) + std::fabs(r[ray.kz]);
    const T u = c.x * b.y - c.y * b.x;
    const T v = a.x * c.y - a.y * c.x;
    const T w = b.x * a.y - b.y * a.x;
    const T least = u < v ? (u < w ? u : w) : (v < w ? v : w);
    const T most = u > v ? (u > w ? u : w) : (v > w ? v : w);
    // Below the threshold products may have lost bits to underflow.
    const T size = ((std::fabs(a.x) + std::fabs(a.y)) + (std::fabs(b.x) + std::fabs(b.y))) +
                   (std::fabs(c.x) + std::fabs(c.y));
    const T error = detail::edge_error(kRounding<T>, size, depth) + detail::kEdgeThreshold<T>;
    // Written so that NaN and infinity are "not sure".
    if (rule == EdgeRule::kInclusive && least < -error && most > error) return std::nullopt;
    const auto hit = detail::triangle_in_wide(ray, vertices, {a, b, c}, rule);
    if (hit || rule == EdgeRule::kHalfOpen) return hit;
    return detail::near_edge(ray, vertices);
}

}  // namespace cobble::renderer
