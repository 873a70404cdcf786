// SPDX-License-Identifier: MIT
#include "renderer/integrator/seams.hpp"

#include <cmath>
#include <limits>

#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"
#include "renderer/scene/shape_bounds.hpp"

namespace cobble::renderer {
namespace {

/// A face of a see-through body, as a ray meets it.
template <typename T>
struct Face {
    T index = 0;  ///< 0: not see-through
    bool leaving = false;
};

template <typename T>
Face<T> face_at(const ShadingScene<T>& scene, const Ray<T>& ray, const Hit<T>& hit) {
    const ir::MaterialId id = scene.source->objects[hit.object.value].material;
    const T index = scene.material(id).refraction_index;
    if (!(index > T(0))) return {};
    const ir::Object& object = scene.source->objects[hit.object.value];
    if (object.kind == ir::ShapeKind::kBox &&
        !scene.geometry.geometry.places[hit.object.value].instance) {
        const T along = ray.direction[hit.face / 2];
        return {index, hit.face % 2 == 1 ? along > T(0) : along < T(0)};
    }
    const SurfacePoint<T> point = surface_at(scene.geometry, ray, hit, false);
    return {index, math::dot(ray.direction, point.geometric_normal) > T(0)};
}

/// A ray in the plane of a seam, or through an edge, meets faces of several blocks at one t. Moved
/// toward the middle of the box's face that it meets, by more than rounding, it meets those of two.
/// t is that of the unmoved ray to the bit: it depends on the axis of the face alone.
template <typename T>
Ray<T> toward_middle(const ShadingScene<T>& scene, Ray<T> ray, const Hit<T>& hit) {
    const ir::Object& object = scene.source->objects[hit.object.value];
    const bool placed = scene.geometry.geometry.places[hit.object.value].instance;
    if (object.kind != ir::ShapeKind::kBox || placed) return ray;
    const auto box = narrow_box<T>(scene.source->boxes[object.shape], scene.geometry.origin);
    for (std::size_t i = 0; i < 3; ++i) {
        if (i == hit.face / 2) continue;
        const T at = ray.origin[i] + ray.direction[i] * hit.t;
        const T size = std::fabs(ray.origin[i]) + std::fabs(box.lo[i]) + std::fabs(box.hi[i]);
        const T step = 4 * std::numeric_limits<T>::epsilon() * size;
        const T middle = box.lo[i] + (box.hi[i] - box.lo[i]) / 2;
        ray.origin[i] += at < middle ? step : -step;
    }
    return ray;
}

/// What else the ray, which meets nothing between its t_min and `hit`, meets at the very t of that.
/// Nothing if the moved ray meets something shortly before: then it is an outer edge that the ray
/// passes, not a seam.
template <typename T>
Hit<T> tied_with(const ShadingScene<T>& scene, const Ray<T>& ray, const Hit<T>& hit) {
    constexpr T kInfinity = std::numeric_limits<T>::infinity();
    Ray<T> moved = toward_middle(scene, ray, hit);
    moved.t_min = ray.t_min + (hit.t - ray.t_min) / 2;
    moved.t_max = std::nextafter(hit.t, kInfinity);
    Counters uncounted;
    const auto other =
        closest_hit(scene.geometry, moved, Exclude{hit.object, hit.face, false}, uncounted);
    return other.t == hit.t ? other : Hit<T>{};
}

template <typename T>
struct Body {
    std::uint32_t object = 0;
    BoxBounds<T> box;
};

template <typename T>
BoxBounds<T> around(const ShadingScene<T>& scene, std::uint32_t index) {
    const PreparedScene<T>& prepared = scene.geometry;
    const ir::Object& object = scene.source->objects[index];
    const auto place = prepared.geometry.places[index];
    if (place.instance) return prepared.geometry.instances[place.index].world_bounds;
    if (object.kind == ir::ShapeKind::kBox) {
        return narrow_box<T>(scene.source->boxes[object.shape], prepared.origin);
    }
    BoxBounds<T> box;
    for (const math::Vec3d p : scene.source->meshes[object.shape].positions) {
        box.add(prepared.to_local(p));
    }
    return box;
}

/// A face in common is enough.
template <typename T>
bool meet(const BoxBounds<T>& a, const BoxBounds<T>& b) {
    bool apart = false;
    for (std::size_t i = 0; i < 3; ++i) apart = apart || a.hi[i] < b.lo[i] || b.hi[i] < a.lo[i];
    return !apart;
}

}  // namespace

template <typename T>
void cross_seams(const ShadingScene<T>& scene, Ray<T> ray, Hit<T>& hit) {
    if (scene.touching.empty()) return;
    // Each turn ends farther on, behind one body more.
    while (hit && scene.touching[hit.object.value] != 0) {
        const Face<T> here = face_at(scene, ray, hit);
        if (!(here.index > T(0))) return;
        const Hit<T> other = tied_with(scene, ray, hit);
        if (!other) return;
        const Face<T> there = face_at(scene, ray, other);
        if (!(there.index > T(0)) || there.leaving == here.leaving) return;
        const Hit<T> entered = here.leaving ? other : hit;
        if (here.index != there.index) {
            hit = entered;
            return;
        }
        ray.t_min = hit.t;
        Counters uncounted;
        hit = closest_hit(scene.geometry, ray, Exclude{entered.object, entered.face, true},
                          uncounted);
    }
}

template <typename T>
std::vector<std::uint8_t> touching_bodies(const ShadingScene<T>& scene) {
    const ir::Scene& source = *scene.source;
    std::vector<Body<T>> bodies;
    for (std::uint32_t i = 0; i < source.objects.size(); ++i) {
        const ir::Object& object = source.objects[i];
        const bool flat = object.kind == ir::ShapeKind::kBox || object.kind == ir::ShapeKind::kMesh;
        if (!flat || !(scene.material(object.material).refraction_index > T(0))) continue;
        bodies.push_back({i, around(scene, i)});
    }
    // Beyond so many a pair by pair comparison costs more than it saves: all of them may.
    constexpr std::size_t kCompared = 1000;
    std::vector<std::uint8_t> touching(source.objects.size(), 0);
    bool any = bodies.size() > kCompared;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (bodies.size() > kCompared) touching[bodies[i].object] = 1;
        if (bodies.size() > kCompared) continue;
        for (std::size_t k = 0; k < i; ++k) {
            if (!meet(bodies[i].box, bodies[k].box)) continue;
            touching[bodies[i].object] = touching[bodies[k].object] = 1;
            any = true;
        }
    }
    if (!any) touching = {};
    return touching;
}

template std::vector<std::uint8_t> touching_bodies(const ShadingScene<float>&);
template std::vector<std::uint8_t> touching_bodies(const ShadingScene<double>&);
template void cross_seams(const ShadingScene<float>&, Ray<float>, Hit<float>&);
template void cross_seams(const ShadingScene<double>&, Ray<double>, Hit<double>&);

}  // namespace cobble::renderer
