// SPDX-License-Identifier: MIT
#include "tests/hard/wrong_shapes.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "renderer/query/query.hpp"

namespace cobble::test {

namespace {

std::optional<renderer::BoxHit<float>> slabs(const FloatRay& ray,
                                             const renderer::BoxBounds<float>& box,
                                             math::Vec3<float> inverse) {
    renderer::BoxHit<float> hit{-std::numeric_limits<float>::infinity(),
                                std::numeric_limits<float>::infinity(), 0, 0};
    for (std::uint32_t i = 0; i < 3; ++i) {
        const float a = (box.lo[i] - ray.origin[i]) * inverse[i];
        const float b = (box.hi[i] - ray.origin[i]) * inverse[i];
        const bool back = a > b;
        if (std::min(a, b) > hit.near) hit.near_face = 2 * i + (back ? 1 : 0);
        if (std::max(a, b) < hit.far) hit.far_face = 2 * i + (back ? 0 : 1);
        hit.near = std::max(std::min(a, b), hit.near);
        hit.far = std::min(std::max(a, b), hit.far);
    }
    if (!(hit.near <= hit.far)) return std::nullopt;
    return hit;
}

}  // namespace

std::optional<renderer::BoxHit<float>> nan_slabs(const FloatRay& ray,
                                                 const renderer::BoxBounds<float>& box) {
    return slabs(ray, box, {1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z});
}

std::optional<renderer::BoxHit<float>> rough_reciprocal(const FloatRay& ray,
                                                        const renderer::BoxBounds<float>& box) {
    // Sign, exponent and the first 12 bits of the fraction.
    const auto rough = [](float x) {
        return std::bit_cast<float>(std::bit_cast<std::uint32_t>(1 / x) & 0xfffff800U);
    };
    return slabs(ray, box,
                 {rough(ray.direction.x), rough(ray.direction.y), rough(ray.direction.z)});
}

std::optional<renderer::BoxHit<float>> sound_box(const FloatRay& ray,
                                                 const renderer::BoxBounds<float>& box) {
    return renderer::intersect_box(renderer::RaySlabs<float>(ray.origin, ray.direction), box);
}

std::optional<renderer::Roots<float>> plain_quadratic(float a, float b, float c) {
    const float discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return std::nullopt;
    const float root = std::sqrt(discriminant);
    const float first = (-b - root) / (2 * a);
    const float second = (-b + root) / (2 * a);
    return first < second ? renderer::Roots<float>{first, second}
                          : renderer::Roots<float>{second, first};
}

std::optional<renderer::Roots<float>> plain_sphere(const FloatRay& ray, math::Vec3<float> center,
                                                   float radius) {
    const auto f = ray.origin - center;
    return plain_quadratic(dot(ray.direction, ray.direction), 2 * dot(f, ray.direction),
                           dot(f, f) - radius * radius);
}

std::optional<renderer::Roots<float>> sound_sphere(const FloatRay& ray, math::Vec3<float> center,
                                                   float radius) {
    return renderer::intersect_sphere(ray.origin, ray.direction, center, radius);
}

std::optional<float> parallel_epsilon(const FloatRay& ray, const renderer::PlaneKey& plane) {
    const auto n = plane.normal.to<float>();
    const float along = dot(n, ray.direction);
    if (std::fabs(along) < 1e-6F) return std::nullopt;
    return (static_cast<float>(plane.offset) - dot(n, ray.origin)) / along;
}

std::optional<float> sound_plane(const FloatRay& ray, const renderer::PlaneKey& plane) {
    return renderer::intersect_plane(ray.origin, ray.direction, plane);
}

float moller_trumbore_t(const FloatRay& ray, const Triangle& v) {
    const auto e1 = v[1] - v[0];
    const auto e2 = v[2] - v[0];
    return dot(e2, cross(ray.origin - v[0], e1)) / dot(e1, cross(ray.direction, e2));
}

renderer::Hit<float> Kernels::operator()(const renderer::PreparedScene<float>& scene,
                                         const FloatRay& ray) const {
    const renderer::RayShear<float> shear(ray.origin, ray.direction);
    const renderer::RaySlabs<float> slabs(ray.origin, ray.direction);
    renderer::Hit<float> best;
    best.t = ray.t_max;
    const auto offer = [&](float t, ir::ObjectId object, std::uint32_t face, float u, float v) {
        if (!(t > ray.t_min)) return false;
        const bool before = t < best.t || (t == best.t && best && object < best.object);
        if (before) best = {t, object, face, u, v};
        return true;
    };
    const auto& g = scene.geometry;
    for (const auto& t : g.triangles) {
        if (!triangle(shear, t.vertices)) continue;
        const auto hit = renderer::intersect_triangle(shear, t.vertices);
        if (own_t) {
            offer(moller_trumbore_t(ray, t.vertices), t.object, t.face, 0, 0);
        } else if (hit) {
            const auto span = renderer::slab_span(slabs, renderer::bounds_of(t.vertices));
            offer(renderer::clamp_to(span, hit->t), t.object, t.face, hit->u, hit->v);
        }
    }
    for (const auto& s : g.spheres) {
        const auto roots = sphere(ray, s.center, s.radius);
        if (roots && !offer(roots->near, s.object, 0, 0, 0)) offer(roots->far, s.object, 0, 0, 0);
    }
    for (const auto& b : g.boxes) {
        const auto hit = box(ray, b.bounds);
        if (!hit || offer(hit->near, b.object, hit->near_face, 0, 0)) continue;
        offer(hit->far, b.object, hit->far_face, 0, 0);
    }
    for (const auto& p : g.planes) {
        const auto t = plane(ray, g.plane_keys[p.first]);
        if (t) offer(*t, p.object, 0, 0, 0);
    }
    if (!best) best.t = 0;
    return best;
}

}  // namespace cobble::test
