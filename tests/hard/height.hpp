// SPDX-License-Identifier: MIT
// How far a point is above a surface of a prepared scene, without rounding: what the bounds that
// the renderer states are compared with.
#pragma once

#include "tests/hard/scenes.hpp"
#include "tests/oracle/exact.hpp"

namespace cobble::test {

/// The face of the plane or mesh, of the box, or the sphere, as the ray loop holds it.
template <typename T>
struct Surface {
    ir::ShapeKind kind = ir::ShapeKind::kSphere;
    std::array<Vec3<T>, 3> triangle;
    renderer::SphereKey<T> sphere;
    renderer::BoxBounds<T> box;
    std::uint32_t box_face = 0;
    renderer::PlaneKey plane;
    bool placed = false;
    math::Affine<T> to_object;  ///< if placed
};

/// At rest: of a moving thing its first key.
template <typename T>
Surface<T> surface_of(const renderer::PreparedScene<T>& scene, ir::ObjectId object,
                      std::uint32_t face) {
    const auto& g = scene.geometry;
    Surface<T> s;
    s.kind = scene.source->objects[object.value].kind;
    s.box_face = face;
    const auto find = [&](const auto& triangles) {
        for (const auto& t : triangles) {
            const bool same_face = s.kind != ir::ShapeKind::kMesh || t.face == face;
            if ((s.placed || t.object == object) && same_face) s.triangle = t.vertices;
        }
    };
    const auto place = g.places[object.value];
    s.placed = place.instance;
    if (s.placed) {
        const auto& i = g.instances[place.index];
        s.to_object = g.instance_keys[i.first_key].world_to_object;
        s.sphere = {i.sphere.center, i.sphere.radius};
        s.box = i.box.bounds;
        s.triangle = i.triangle.vertices;
        if (s.kind == ir::ShapeKind::kMesh) find(g.meshes[i.mesh].triangles);
        return s;
    }
    if (s.kind == ir::ShapeKind::kPlane) s.plane = g.plane_keys[g.planes[place.index].first];
    find(g.triangles);
    for (const auto& sphere : g.spheres) {
        if (sphere.object == object) s.sphere = {sphere.center, sphere.radius};
    }
    for (const auto& box : g.boxes) {
        if (box.object == object) s.box = box.bounds;
    }
    return s;
}

/// How steeply a direction leads out of a plane or a triangle, not placed: the sine, exact sign.
template <typename T>
double rise(const Surface<T>& s, Vec3<T> direction) {
    using oracle::exact;
    const Vec3d d = direction.template to<double>();
    const auto at = [&](std::size_t i) { return exact(s.triangle[i].template to<double>()); };
    const auto n =
        s.kind == ir::ShapeKind::kPlane
            ? exact(s.plane.normal)
            : oracle::exact_cross(oracle::minus(at(1), at(0)), oracle::minus(at(2), at(0)));
    const double size = std::sqrt(oracle::exact_dot(n, n).near().hi) * length(d);
    return oracle::exact_dot(n, exact(d)).near().hi / size;
}

/// In world units, along the normal; negative inside or behind. To a point of a placed thing it is
/// taken from where the renderer maps the point to, in T: that is where a ray's test begins.
template <typename T>
double height(const Surface<T>& s, Vec3<T> point) {
    using oracle::Exact;
    using oracle::exact;
    const Vec3d p = (s.placed ? s.to_object.point(point) : point).template to<double>();
    double above = 0;
    Vec3d normal;
    switch (s.kind) {
        case ir::ShapeKind::kSphere: {
            // |p - c| - r without cancellation: (p - c) . (p - c) - r^2 over the sum.
            const Vec3d c = s.sphere.center.template to<double>();
            const double r{s.sphere.radius};
            const auto f = oracle::minus(exact(p), exact(c));
            above = (oracle::exact_dot(f, f) - Exact(r) * Exact(r)).near().hi / (length(p - c) + r);
            normal = normalize(p - c);
            break;
        }
        case ir::ShapeKind::kBox: {
            const std::size_t axis = s.box_face / 2;
            const bool upper = s.box_face % 2 == 1;
            const double at{upper ? s.box.hi[axis] : s.box.lo[axis]};
            above = upper ? p[axis] - at : at - p[axis];
            normal[axis] = upper ? 1 : -1;
            break;
        }
        case ir::ShapeKind::kPlane: {
            const Vec3d n = s.plane.normal;
            above = (oracle::exact_dot(exact(n), exact(p)) - Exact(s.plane.offset)).near().hi /
                    length(n);
            normal = n;
            break;
        }
        default: {
            const auto at = [&](std::size_t i) {
                return exact(s.triangle[i].template to<double>());
            };
            const auto n =
                oracle::exact_cross(oracle::minus(at(1), at(0)), oracle::minus(at(2), at(0)));
            const double size = std::sqrt(oracle::exact_dot(n, n).near().hi);
            above = oracle::exact_dot(n, oracle::minus(exact(p), at(0))).near().hi / size;
            normal = Vec3d{n.x.near().hi, n.y.near().hi, n.z.near().hi} / size;
            break;
        }
    }
    if (!s.placed) return above;
    return above / length(s.to_object.template to<double>().transposed_vector(normal));
}

}  // namespace cobble::test
