// SPDX-License-Identifier: MIT
#include "renderer/stability/flattened.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "renderer/scene/flat.hpp"
#include "renderer/scene/shape_bounds.hpp"

namespace cobble::renderer {
namespace {

using math::Vec3d;
using Vertices = std::array<Vec3d, 3>;

/// What the vertices of the object are narrowed relative to.
Vec3d origin_of(const PreparedScene<float>& narrow, const ir::Object& object, ir::ObjectId id) {
    if (object.placement.count == 0) return narrow.origin;
    for (const auto& instance : narrow.geometry.instances) {
        if (instance.object == id) return instance.shape_origin;
    }
    return {};
}

/// Seen from the front, at the distance of its nearest vertex.
double pixels_of(const Vertices& v, Vec3d eye, double pixel) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3d p : v) nearest = std::min(nearest, length(p - eye));
    const double wide = nearest * pixel;
    return length(cross(v[1] - v[0], v[2] - v[0])) / 2 / (wide * wide);
}

}  // namespace

double flattened_pixels(const PreparedScene<float>& narrow, const ir::Scene& scene,
                        const PreparationNote& note, double pixel) {
    const ir::Object& object = scene.objects[note.object.value];
    const bool mesh = object.kind == ir::ShapeKind::kMesh;
    if (!mesh && object.kind != ir::ShapeKind::kTriangle) {
        return std::numeric_limits<double>::infinity();
    }
    const Vec3d origin = origin_of(narrow, object, note.object);
    const std::size_t faces = mesh ? scene.meshes[object.shape].faces.size() : 1;
    double sum = 0;
    for (std::uint32_t face = note.face; face < faces; ++face) {
        Vertices v = mesh ? face_vertices<double>(scene.meshes[object.shape], face, {})
                          : scene.triangles[object.shape].keys[0];
        if (!flat(narrow_vertices<float>(v, origin)) || flat(v)) continue;
        if (object.placement.count > 0) {
            const auto& map = scene.placements[object.placement.first].object_to_world;
            for (Vec3d& p : v) p = map.point(p);
        }
        sum += pixels_of(v, scene.camera.center, pixel);
    }
    return sum;
}

}  // namespace cobble::renderer
