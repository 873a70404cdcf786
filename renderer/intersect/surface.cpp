// SPDX-License-Identifier: MIT
#include "renderer/intersect/surface.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "ir/math/elementary.hpp"
#include "ir/math/inverse.hpp"
#include "renderer/geometry/wide.hpp"
#include "renderer/intersect/surface_forms.hpp"
#include "renderer/scene/moving.hpp"
#include "renderer/scene/rebase.hpp"
#include "renderer/scene/shape_bounds.hpp"

namespace cobble::renderer {

namespace {

using math::Affined;
using math::Vec2d;
using math::Vec3;
using math::Vec3d;

/// The surface in the shape's own space; directions and coordinates in double.
template <typename T>
struct Local {
    Vec3<Wide<T>> position;
    Vec3d normal;  ///< any length
    Vec3d shading{};
    bool smooth = false;
    Vec2d uv;
    Vec3d dp_du, dp_dv;
    bool has_uv = false;
    bool has_tangents = false;
};

/// dp/du and dp/dv of a triangle from its edges and those of its texture coordinates.
template <typename T>
void set_tangents(Local<T>& local, Vec3d e1, Vec3d e2, Vec2d d1, Vec2d d2) {
    const double det = d1.x * d2.y - d1.y * d2.x;
    local.dp_du = (e1 * d2.y - e2 * d1.y) / det;
    local.dp_dv = (e2 * d1.x - e1 * d2.x) / det;
    local.has_tangents = det != 0 && finite(local.dp_du) && finite(local.dp_dv);
    if (!local.has_tangents) local.dp_du = local.dp_dv = {};
}

template <typename T>
Local<T> on_triangle(const std::array<Vec3<T>, 3>& v, const Hit<T>& hit) {
    using W = Wide<T>;
    Local<T> local;
    local.position = triangle_point(widen(v[0]), widen(v[1]), widen(v[2]), W(hit.u), W(hit.v));
    local.normal = triangle_normal(v[0], v[1], v[2]);
    return local;
}

template <typename T>
Local<T> on_face(const ir::Mesh& mesh, Vec3d origin, const Hit<T>& hit, bool want_uv) {
    const auto v = face_vertices<T>(mesh, hit.face, origin);
    Local<T> local = on_triangle(v, hit);
    const auto& corners = mesh.faces[hit.face].corners;
    const double b1{hit.u};
    const double b2{hit.v};
    const double b0 = (1 - b1) - b2;
    constexpr std::uint32_t kNone = ir::Mesh::kNone;
    if (corners[0].normal != kNone && corners[1].normal != kNone && corners[2].normal != kNone) {
        const Vec3d n0 = mesh.normals[corners[0].normal];
        const Vec3d n1 = mesh.normals[corners[1].normal];
        const Vec3d n2 = mesh.normals[corners[2].normal];
        local.shading = (n0 * b0 + n1 * b1) + n2 * b2;
        local.smooth = true;
    }
    if (want_uv && corners[0].uv != kNone && corners[1].uv != kNone && corners[2].uv != kNone) {
        const Vec2d t0 = mesh.uvs[corners[0].uv];
        const Vec2d t1 = mesh.uvs[corners[1].uv];
        const Vec2d t2 = mesh.uvs[corners[2].uv];
        const Vec2d d1{t1.x - t0.x, t1.y - t0.y};
        const Vec2d d2{t2.x - t0.x, t2.y - t0.y};
        local.uv = {t0.x + (d1.x * b1 + d2.x * b2), t0.y + (d1.y * b1 + d2.y * b2)};
        local.has_uv = true;
        const Vec3d p0 = v[0].template to<double>();
        set_tangents(local, v[1].template to<double>() - p0, v[2].template to<double>() - p0, d1,
                     d2);
    }
    return local;
}

/// u around +y from +z, v from the south pole up.
template <typename T>
Local<T> on_sphere(Vec3<T> center, T radius, Vec3<Wide<T>> near, bool want_uv) {
    using W = Wide<T>;
    Local<T> local;
    const Vec3<W> c = widen(center);
    // A radius above 0 was accepted, so that the hit is not the centre.
    const Vec3<W> n = sphere_normal(c, near);
    local.position = c + n * W(radius);
    local.normal = to_double(n);
    if (!want_uv) return local;
    const Vec3d d = local.normal;
    const double turn = math::atan2(d.x, d.z) / (2 * math::kPi);
    const double down = -d.y < -1 ? -1 : -d.y > 1 ? 1 : -d.y;
    local.uv = {turn < 0 ? turn + 1 : turn, math::acos(down) / math::kPi};
    local.has_uv = true;
    const double s = std::sqrt(d.x * d.x + d.z * d.z);
    const double r{radius};
    if (s > 0) {
        local.dp_du = Vec3d{d.z, 0, -d.x} * (2 * math::kPi * r);
        local.dp_dv = Vec3d{-d.y * d.x / s, s, -d.y * d.z / s} * (math::kPi * r);
        local.has_tangents = true;
    }
    return local;
}

/// Each face from 0 to 1, upright on the four sides; seen from outside u runs to the right.
template <typename T>
Local<T> on_box(const BoxBounds<T>& box, std::uint32_t face, Vec3<Wide<T>> near, bool want_uv) {
    const std::size_t axis = face / 2;
    const bool upper = face % 2 == 1;
    Local<T> local;
    local.normal[axis] = upper ? 1 : -1;
    local.position = box_point(box, local.normal, near);
    if (!want_uv) return local;
    const Vec3d size = box.hi.template to<double>() - box.lo.template to<double>();
    const Vec3d p = to_double(local.position) - box.lo.template to<double>();
    // Axis and sense of u, then of v.
    std::size_t ua = 0;
    std::size_t va = 1;
    bool u_back = false;
    bool v_back = false;
    if (axis == 0) {
        ua = 2;
        u_back = upper;
    } else if (axis == 1) {
        va = 2;
        v_back = upper;
    } else {
        u_back = !upper;
    }
    if (!(size[ua] > 0) || !(size[va] > 0)) return local;
    const double u = p[ua] / size[ua];
    const double v = p[va] / size[va];
    local.uv = {u_back ? 1 - u : u, v_back ? 1 - v : v};
    local.dp_du[ua] = u_back ? -size[ua] : size[ua];
    local.dp_dv[va] = v_back ? -size[va] : size[va];
    local.has_uv = local.has_tangents = true;
    return local;
}

/// u = u_axis . p + u_offset, v likewise, for points of the plane with this normal: how p moves.
template <typename T>
void set_plane_uv(Local<T>& local, const ir::Plane& plane, const Affined& world_to_plane,
                  Vec3d p_world) {
    const Vec3d p = world_to_plane.point(p_world);
    local.uv = {dot(plane.u_axis, p) + plane.u_offset, dot(plane.v_axis, p) + plane.v_offset};
    local.has_uv = true;
    const Vec3d ua = world_to_plane.transposed_vector(plane.u_axis);
    const Vec3d va = world_to_plane.transposed_vector(plane.v_axis);
    const Vec3d un = cross(va, local.normal);
    const Vec3d vn = cross(local.normal, ua);
    const double det = dot(ua, un);
    local.dp_du = un / det;
    local.dp_dv = vn / det;
    local.has_tangents = det != 0 && finite(local.dp_du) && finite(local.dp_dv);
    if (!local.has_tangents) local.dp_du = local.dp_dv = {};
}

Affined between(const ir::Scene& scene, const ir::Keys& keys, double time) {
    if (keys.count == 0) return {};
    const auto at = segment_at(keys.count, time);
    const Affined a = scene.placements[keys.first + at.index].world_to_object;
    if (at.fraction == 0) return a;
    const Affined b = scene.placements[keys.first + at.index + 1].world_to_object;
    return lerp(a, b, at.fraction);
}

template <typename T>
Local<T> on_plane(const PreparedScene<T>& scene, const Ray<T>& ray, const Hit<T>& hit,
                  const ir::Object& object, bool want_uv) {
    using W = Wide<T>;
    const auto& g = scene.geometry;
    const PlaneKey key = plane_at(g, g.planes[g.places[hit.object.value].index], ray.time);
    const Vec3<W> n = key.normal.to<W>();
    const Vec3<W> near = along(ray.origin, ray.direction, hit.t);
    Local<T> local;
    // Back onto the plane along its normal.
    local.position = near - n * ((dot(n, near) - W(key.offset)) / dot(n, n));
    local.normal = key.normal;
    if (want_uv) {
        set_plane_uv(local, scene.source->planes[object.shape],
                     between(*scene.source, object.placement, double{ray.time}),
                     to_double(local.position) + scene.origin);
    }
    return local;
}

Vec3d magnitudes(const Affined& map, Vec3d p, bool with_offset) {
    Vec3d sum;
    for (std::size_t i = 0; i < 3; ++i) {
        sum[i] = (std::fabs(map.rows[i][0] * p.x) + std::fabs(map.rows[i][1] * p.y)) +
                 std::fabs(map.rows[i][2] * p.z);
        if (with_offset) sum[i] += std::fabs(map.rows[i][3]);
    }
    return sum;
}

/// Through the matrices of an instance: the point out of it, normals by the transpose.
template <typename W>
Vec3<W> map_point(const Affined& map, Vec3<W> p) {
    Vec3<W> result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] =
            ((W(map.rows[i][0]) * p.x + W(map.rows[i][1]) * p.y) + W(map.rows[i][2]) * p.z) +
            W(map.rows[i][3]);
    }
    return result;
}

/// Narrows, and finishes what does not depend on the shape.
template <typename T>
SurfacePoint<T> finish(const ir::Object& object, const Hit<T>& hit, const Local<T>& local,
                       const Affined* to_world, const Affined* to_object) {
    SurfacePoint<T> s;
    s.kind = object.kind;
    s.object = hit.object;
    s.face = hit.face;
    s.material = object.material;
    Vec3<Wide<T>> position = local.position;
    Vec3d normal = local.normal;
    Vec3d shading = local.shading;
    Vec3d du = local.dp_du;
    Vec3d dv = local.dp_dv;
    if (to_world != nullptr) {
        position = map_point(*to_world, position);
        normal = to_object->transposed_vector(normal);
        shading = to_object->transposed_vector(shading);
        du = to_world->vector(du);
        dv = to_world->vector(dv);
    }
    normal = unit(normal);
    s.position = position.template to<T>();
    s.geometric_normal = normal.to<T>();
    s.shading_normal = s.geometric_normal;
    const Vec3d smooth = unit(shading);
    if (local.smooth && dot(smooth, smooth) > 0.5) s.shading_normal = smooth.to<T>();
    s.uv = {static_cast<T>(local.uv.x), static_cast<T>(local.uv.y)};
    s.has_uv = local.has_uv;
    // What T can not hold is no tangent.
    constexpr double kMost{std::numeric_limits<T>::max()};
    s.has_tangents = local.has_tangents && std::fabs(du.x) + std::fabs(du.y) + std::fabs(du.z) +
                                                   std::fabs(dv.x) + std::fabs(dv.y) +
                                                   std::fabs(dv.z) <=
                                               kMost;
    if (s.has_tangents) {
        s.dp_du = du.to<T>();
        s.dp_dv = dv.to<T>();
    }
    // The position was rounded once. A ray that starts there is tested in the wide type, but for an
    // instance it is first mapped in T: four roundings of each row, magnified on the way back; and
    // in double its inverse was rounded too.
    double error = rounding_error<T>(normal, to_double(position));
    if (to_world != nullptr) {
        const Vec3d p = to_double(position);
        const Vec3d mapped =
            magnitudes(*to_object, {std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}, true) *
            double{gamma<T>(4)};
        error += along_normal(normal, magnitudes(*to_world, mapped, false));
    }
    s.error = static_cast<T>(error);
    return s;
}

template <typename T>
SurfacePoint<T> on_instance(const PreparedScene<T>& scene, const Ray<T>& ray, const Hit<T>& hit,
                            const ir::Object& object, const Instance<T>& instance, bool want_uv) {
    const auto& g = scene.geometry;
    const math::Affine<T> map = world_to_object_at(g, instance, ray.time);
    const auto to_object = map.template to<double>();
    Affined to_world = g.instance_keys[instance.first_key].object_to_world;
    if (instance.keys > 1) {
        // Singular between its keys: nothing that was hit, but defined all the same.
        const auto back = math::inverse(to_object);
        if (back) to_world = *back;
    }
    const Vec3<Wide<T>> near = along(map.point(ray.origin), map.vector(ray.direction), hit.t);
    Local<T> local;
    switch (object.kind) {
        case ir::ShapeKind::kSphere:
            local = on_sphere(instance.sphere.center, instance.sphere.radius, near, want_uv);
            break;
        case ir::ShapeKind::kBox:
            local = on_box(instance.box.bounds, hit.face, near, want_uv);
            break;
        case ir::ShapeKind::kTriangle:
            local = on_triangle(instance.triangle.vertices, hit);
            break;
        case ir::ShapeKind::kMesh:
            local =
                on_face(scene.source->meshes[object.shape], instance.shape_origin, hit, want_uv);
            break;
        case ir::ShapeKind::kPlane:
            break;
    }
    return finish(object, hit, local, &to_world, &to_object);
}

}  // namespace

template <typename T>
SurfacePoint<T> surface_at(const PreparedScene<T>& scene, const Ray<T>& ray, const Hit<T>& hit,
                           bool want_uv) {
    const ir::Scene& source = *scene.source;
    const ir::Object& object = source.objects[hit.object.value];
    const auto& g = scene.geometry;
    const auto place = g.places[hit.object.value];
    want_uv = want_uv && scene.options.texture_coordinates;
    if (place.instance) {
        return on_instance(scene, ray, hit, object, g.instances[place.index], want_uv);
    }
    Local<T> local;
    switch (object.kind) {
        case ir::ShapeKind::kMesh:
            local = on_face(source.meshes[object.shape], scene.origin, hit, want_uv);
            break;
        case ir::ShapeKind::kTriangle: {
            const auto& keys = source.triangles[object.shape].keys;
            local =
                keys.size() > 1
                    ? on_triangle(triangle_at(g, g.moving_triangles[place.index], ray.time), hit)
                    : on_triangle(narrow_vertices<T>(keys[0], scene.origin), hit);
            break;
        }
        case ir::ShapeKind::kSphere: {
            const auto& keys = source.spheres[object.shape].keys;
            const SphereKey<T> sphere = keys.size() > 1
                                            ? sphere_at(g, g.moving_spheres[place.index], ray.time)
                                            : narrow_sphere<T>(keys[0], scene.origin);
            local = on_sphere(sphere.center, sphere.radius, along(ray.origin, ray.direction, hit.t),
                              want_uv);
            break;
        }
        case ir::ShapeKind::kBox:
            local = on_box(narrow_box<T>(source.boxes[object.shape], scene.origin), hit.face,
                           along(ray.origin, ray.direction, hit.t), want_uv);
            break;
        case ir::ShapeKind::kPlane:
            local = on_plane(scene, ray, hit, object, want_uv);
            break;
    }
    return finish(object, hit, local, nullptr, nullptr);
}

template <typename T>
Departure<T> leave(const SurfacePoint<T>& surface, math::Vec3<T> direction, T time) {
    const bool outward = goes_outward(direction, surface.geometric_normal);
    Departure<T> d;
    d.ray.origin = start_off(surface.position, surface.geometric_normal, surface.error, outward);
    d.ray.direction = direction;
    d.ray.time = time;
    d.exclude = {surface.object, surface.face, !outward};
    return d;
}

template <typename T>
Departure<T> leave_toward(const SurfacePoint<T>& surface, math::Vec3<T> target, T time) {
    Departure<T> d = leave(surface, target - surface.position, time);
    const Way<T> way = way_to(d.ray.origin, target, surface.geometric_normal);
    d.ray.direction = way.direction;
    d.ray.t_max = way.t_max;
    return d;
}

#define COBBLE_INSTANTIATE(T)                                                                  \
    template SurfacePoint<T> surface_at(const PreparedScene<T>&, const Ray<T>&, const Hit<T>&, \
                                        bool);                                                 \
    template Departure<T> leave(const SurfacePoint<T>&, math::Vec3<T>, T);                     \
    template Departure<T> leave_toward(const SurfacePoint<T>&, math::Vec3<T>, T);
COBBLE_INSTANTIATE(float)
COBBLE_INSTANTIATE(double)
#undef COBBLE_INSTANTIATE

}  // namespace cobble::renderer
