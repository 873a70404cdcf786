// SPDX-License-Identifier: MIT
// Ray-triangle tests that are known to leak, kept so that the tests of watertightness can be seen
// to find them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "ir/math/vec.hpp"
#include "renderer/geometry/hit.hpp"
#include "renderer/geometry/ray.hpp"
#include "renderer/geometry/triangle.hpp"
#include "renderer/scene/prepared_scene.hpp"
#include "renderer/stability/stability.hpp"

namespace cobble::test {

using Triangle = std::array<math::Vec3<float>, 3>;

/// Woop's test with its products and differences contracted to fused multiply-adds, as compilers do
/// when allowed: the two triangles of an edge no longer compute the same number.
inline bool contracted_edges(const renderer::RayShear<float>& ray, const Triangle& v) {
    const auto a = renderer::detail::shear(ray, v[0] - ray.origin);
    const auto b = renderer::detail::shear(ray, v[1] - ray.origin);
    const auto c = renderer::detail::shear(ray, v[2] - ray.origin);
    const float u = std::fma(c.x, b.y, -(c.y * b.x));
    const float w = std::fma(a.x, c.y, -(a.y * c.x));
    const float x = std::fma(b.x, a.y, -(b.y * a.x));
    return !((u < 0 || w < 0 || x < 0) && (u > 0 || w > 0 || x > 0)) && u + w + x != 0;
}

/// Möller and Trumbore (1997): each triangle has an origin of its own. Edges reach out by `more`.
inline bool within_weights(const renderer::RayShear<float>& ray, const Triangle& v, float more) {
    const auto e1 = v[1] - v[0];
    const auto e2 = v[2] - v[0];
    const auto p = cross(ray.direction, e2);
    const float det = dot(e1, p);
    if (det == 0) return false;
    const auto s = ray.origin - v[0];
    const float u = dot(s, p) / det;
    const auto q = cross(s, e1);
    const float w = dot(ray.direction, q) / det;
    return u >= -more && w >= -more && u + w <= 1 + more;
}

inline bool moller_trumbore(const renderer::RayShear<float>& ray, const Triangle& v) {
    return within_weights(ray, v, 0);
}

/// The same with edges made to overlap, against leaks: things look larger than they are.
inline bool generous_edges(const renderer::RayShear<float>& ray, const Triangle& v) {
    return within_weights(ray, v, 1e-5F);
}

/// The same, refusing small determinants by an absolute measure.
inline bool absolute_epsilon(const renderer::RayShear<float>& ray, const Triangle& v) {
    const auto p = cross(ray.direction, v[2] - v[0]);
    return std::fabs(dot(v[1] - v[0], p)) > 1e-7F && moller_trumbore(ray, v);
}

inline bool sound(const renderer::RayShear<float>& ray, const Triangle& v) {
    return renderer::intersect_triangle(ray, v).has_value();
}

/// Every triangle by itself: `accepts` decides, what is met is right.
template <typename Accepts>
renderer::Hit<float> cast_by(const renderer::PreparedScene<float>& scene,
                             const renderer::Ray<float>& ray, const renderer::Exclude& exclude,
                             Accepts accepts) {
    const renderer::RayShear<float> shear(ray.origin, ray.direction);
    renderer::Hit<float> best;
    for (const auto& t : scene.geometry.triangles) {
        if (t.object == exclude.object && t.face == exclude.face) continue;
        if (!accepts(shear, t.vertices)) continue;
        const auto hit = renderer::intersect_triangle(shear, t.vertices);
        if (!hit || !(hit->t > ray.t_min) || (best && !(hit->t < best.t))) continue;
        best = {hit->t, t.object, t.face, hit->u, hit->v};
    }
    return best;
}

/// For a scene of baked triangles that was prepared for the reference: measure_stability() by a
/// function of one ray.
template <typename OneRay>
void cast_with(renderer::StabilityOptions& options, OneRay one) {
    options.acceleration = renderer::Acceleration::kBvh;
    options.cast = [one](const auto& scene, const auto rays, const auto excludes, const auto hits) {
        for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = one(scene, rays[i], excludes[i]);
    };
}

}  // namespace cobble::test
