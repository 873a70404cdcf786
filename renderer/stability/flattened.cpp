// SPDX-License-Identifier: MIT
#include "renderer/stability/flattened.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "ir/scene/bounds.hpp"
#include "renderer/scene/flat.hpp"
#include "renderer/scene/shape_bounds.hpp"

namespace cobble::renderer {
namespace {

using math::Vec3d;
using Vertices = std::array<Vec3d, 3>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What the vertices of the object are narrowed relative to.
Vec3d origin_of(const PreparedScene<float>& narrow, const ir::Object& object, ir::ObjectId id) {
    if (object.placement.count == 0) return narrow.origin;
    for (const auto& instance : narrow.geometry.instances) {
        if (instance.object == id) return instance.shape_origin;
    }
    return {};
}

std::size_t faces_of(const ir::Scene& scene, const ir::Object& object) {
    return object.kind == ir::ShapeKind::kMesh ? scene.meshes[object.shape].faces.size() : 1;
}

/// In the object's own space.
Vertices face_of(const ir::Scene& scene, const ir::Object& object, std::uint32_t face) {
    return object.kind == ir::ShapeKind::kMesh
               ? face_vertices<double>(scene.meshes[object.shape], face, {})
               : scene.triangles[object.shape].keys[0];
}

bool is_triangles(const ir::Object& object) {
    return object.kind == ir::ShapeKind::kMesh || object.kind == ir::ShapeKind::kTriangle;
}

Vertices in_world(const ir::Scene& scene, const ir::Object& object, Vertices v) {
    if (object.placement.count == 0) return v;
    const auto& map = scene.placements[object.placement.first].object_to_world;
    return {map.point(v[0]), map.point(v[1]), map.point(v[2])};
}

/// Seen from the front, at the distance of its nearest vertex.
double pixels_of(const Vertices& v, Vec3d eye, double pixel) {
    double nearest = kInfinity;
    for (const Vec3d p : v) nearest = std::min(nearest, length(p - eye));
    const double wide = nearest * pixel;
    return length(cross(v[1] - v[0], v[2] - v[0])) / 2 / (wide * wide);
}

}  // namespace

double flattened_pixels(const PreparedScene<float>& narrow, const ir::Scene& scene,
                        const PreparationNote& note, double pixel) {
    const ir::Object& object = scene.objects[note.object.value];
    if (!is_triangles(object)) return kInfinity;
    const Vec3d origin = origin_of(narrow, object, note.object);
    double sum = 0;
    for (std::uint32_t face = note.face; face < faces_of(scene, object); ++face) {
        const Vertices v = face_of(scene, object, face);
        if (!flat(narrow_vertices<float>(v, origin)) || flat(v)) continue;
        sum += pixels_of(in_world(scene, object, v), scene.camera.center, pixel);
    }
    return sum;
}

double object_pixels(const ir::Scene& scene, ir::ObjectId id, double pixel) {
    const ir::Object& object = scene.objects[id.value];
    const Vec3d eye = scene.camera.center;
    if (!is_triangles(object)) {
        const BoxBounds<double> box = ir::SceneBounds(scene).world(object);
        if (box.empty()) return kInfinity;
        Vec3d outside;
        for (std::size_t i = 0; i < 3; ++i) {
            outside[i] = std::max({box.lo[i] - eye[i], eye[i] - box.hi[i], 0.0});
        }
        const double wide = length(box.hi - box.lo) / (length(outside) * pixel);
        return wide * wide;
    }
    double sum = 0;
    for (std::uint32_t face = 0; face < faces_of(scene, object); ++face) {
        sum += pixels_of(in_world(scene, object, face_of(scene, object, face)), eye, pixel);
    }
    return sum;
}

}  // namespace cobble::renderer
