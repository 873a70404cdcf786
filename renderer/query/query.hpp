// SPDX-License-Identifier: MIT
// One ray's search: what is asked, what was found so far, and the tests of single primitives.
// Brute force, the reference's tree and the fast core share every line of it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "renderer/geometry/bounds.hpp"
#include "renderer/geometry/box.hpp"
#include "renderer/geometry/hit.hpp"
#include "renderer/geometry/plane.hpp"
#include "renderer/geometry/ray.hpp"
#include "renderer/geometry/slab.hpp"
#include "renderer/geometry/sphere.hpp"
#include "renderer/geometry/triangle.hpp"
#include "renderer/scene/geometry.hpp"
#include "renderer/scene/moving.hpp"

namespace cobble::renderer {

/// A ray in the coordinates of the world or of an instance, with what each test precomputes.
template <typename T>
struct RayForms {
    RaySlabs<T> slabs;
    RayShear<T> shear;

    RayForms(math::Vec3<T> origin, math::Vec3<T> direction)
        : slabs(origin, direction), shear(origin, direction) {}
    RayForms(const RaySlabs<T>& of_slabs, const RayShear<T>& of_shear)
        : slabs(of_slabs), shear(of_shear) {}
};

/// What is searched and what is found. `best.t` always bounds what may still count. With kAll every
/// hit is kept in `all` instead, and the bound stays.
template <typename T, bool kAll = false>
struct Search {
    Hit<T> best;
    std::vector<Hit<T>>* all = nullptr;
    T t_min = 0;
    T time = 0;
    Exclude exclude;
    EdgeRule rule = EdgeRule::kInclusive;
    std::uint64_t box_tests = 0;
    std::uint64_t primitive_tests = 0;
    /// Inside an instance: where its world box begins; t is not below that.
    T instance_near = std::numeric_limits<T>::lowest();

    /// Takes a hit if it comes first by (t, object, face).
    void offer(T t, ir::ObjectId object, std::uint32_t face, T u, T v) {
        t = t < instance_near ? instance_near : t;
        if (!(t > t_min)) return;
        if constexpr (kAll) {
            if (t < best.t) all->push_back({t, object, face, u, v});
            return;
        }
        const bool before =
            t < best.t || (t == best.t && best.object.valid() &&
                           (object < best.object || (object == best.object && face < best.face)));
        if (before) best = {t, object, face, u, v};
    }
};

/// Not a comparison alone: NaN stays and is refused by offer().
template <typename T>
T clamp_to(const Span<T>& span, T t) {
    return t < span.near ? span.near : t > span.far ? span.far : t;
}

template <typename T, bool kAll>
void test_triangle(const RayForms<T>& ray, const std::array<math::Vec3<T>, 3>& vertices,
                   ir::ObjectId object, std::uint32_t face, Search<T, kAll>& search) {
    ++search.primitive_tests;
    const auto hit = intersect_triangle(ray.shear, vertices, search.rule);
    if (!hit) return;
    if (object == search.exclude.object && face == search.exclude.face) return;
    const Span<T> span = slab_span(ray.slabs, bounds_of(vertices));
    if (span.empty()) return;
    search.offer(clamp_to(span, hit->t), object, face, hit->u, hit->v);
}

template <typename T, bool kAll>
void test_sphere(const RayForms<T>& ray, math::Vec3<T> center, T radius, ir::ObjectId object,
                 Search<T, kAll>& search) {
    ++search.primitive_tests;
    const bool left = object == search.exclude.object;
    if (left && !search.exclude.goes_inside) return;
    const auto roots = intersect_sphere(ray.shear.origin, ray.shear.direction, center, radius);
    if (!roots) return;
    const Span<T> span = slab_span(ray.slabs, bounds_of(center, radius));
    if (span.empty()) return;
    const T near = clamp_to(span, roots->near);
    const bool enters = near > search.t_min && !left;
    if (enters) search.offer(near, object, 0, 0, 0);
    if (!enters || kAll) {
        search.offer(clamp_to(span, roots->far), object, 0, 0, 0);
    }
}

template <typename T, bool kAll>
void test_box(const RayForms<T>& ray, const BoxBounds<T>& box, ir::ObjectId object,
              Search<T, kAll>& search) {
    ++search.primitive_tests;
    const bool left = object == search.exclude.object;
    if (left && !search.exclude.goes_inside) return;
    // The surface's own slabs are its box test, and t needs no clamp: it is one of its slabs.
    const auto hit = intersect_box(ray.slabs, box);
    if (!hit) return;
    const bool enters = hit->near > search.t_min && !left;
    if (enters) search.offer(hit->near, object, hit->near_face, 0, 0);
    if ((!enters || kAll) && (!left || hit->far_face != search.exclude.face)) {
        search.offer(hit->far, object, hit->far_face, 0, 0);
    }
}

template <typename T, bool kAll>
void test_moving_triangle(const Geometry<T>& geometry, const RayForms<T>& ray,
                          const MovingPrimitive& moving, Search<T, kAll>& search) {
    test_triangle(ray, triangle_at(geometry, moving, search.time), moving.object, 0, search);
}

template <typename T, bool kAll>
void test_moving_sphere(const Geometry<T>& geometry, const RayForms<T>& ray,
                        const MovingPrimitive& moving, Search<T, kAll>& search) {
    const auto sphere = sphere_at(geometry, moving, search.time);
    test_sphere(ray, sphere.center, sphere.radius, moving.object, search);
}

/// Planes have no box, and come first or last alike.
template <typename T, bool kAll>
void test_plane(const Geometry<T>& geometry, const RayForms<T>& ray, const MovingPrimitive& plane,
                Search<T, kAll>& search) {
    ++search.primitive_tests;
    if (plane.object == search.exclude.object) return;
    const auto t = intersect_plane(ray.shear.origin, ray.shear.direction,
                                   plane_at(geometry, plane, search.time));
    if (t) search.offer(*t, plane.object, 0, T(0), T(0));
}

/// The box test of an instance, and what is inside by `visit_mesh(mesh, forms)` for a mesh.
template <typename T, bool kAll, typename VisitMesh>
void test_instance(const Geometry<T>& geometry, const RayForms<T>& ray, const Instance<T>& instance,
                   Search<T, kAll>& search, VisitMesh visit_mesh) {
    ++search.box_tests;
    const Span<T> span = slab_span(ray.slabs, instance.world_bounds);
    if (span.empty() || span.far < search.t_min || span.near > search.best.t) return;
    const math::Affine<T> map = world_to_object_at(geometry, instance, search.time);
    const math::Vec3<T> direction = map.vector(ray.shear.direction);
    // A map that flattens the ray to a point (possible between keys) shows nothing.
    if (direction == math::Vec3<T>{}) return;
    const RayForms<T> inside(map.point(ray.shear.origin), direction);
    search.instance_near = span.near;
    switch (instance.kind) {
        case ir::ShapeKind::kSphere:
            test_sphere(inside, instance.sphere.center, instance.sphere.radius, instance.object,
                        search);
            break;
        case ir::ShapeKind::kBox:
            test_box(inside, instance.box.bounds, instance.object, search);
            break;
        case ir::ShapeKind::kTriangle:
            test_triangle(inside, instance.triangle.vertices, instance.object, 0, search);
            break;
        case ir::ShapeKind::kMesh:
            visit_mesh(geometry.meshes[instance.mesh], inside);
            break;
        case ir::ShapeKind::kPlane:
            break;
    }
    search.instance_near = std::numeric_limits<T>::lowest();
}

}  // namespace cobble::renderer
