// SPDX-License-Identifier: MIT
#include "renderer/stability/reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/scene/shape_bounds.hpp"

namespace cobble::renderer {
namespace {

using math::Vec3d;

double sum_of(Vec3d a) { return (std::fabs(a.x) + std::fabs(a.y)) + std::fabs(a.z); }

/// Opposite corners of a box around the primitive, in its own space: exact for a box, the
/// cube around a sphere, and for a triangle the extremes of its vertices.
BoxBounds<double> own_bounds(const ir::Scene& scene, const ir::Object& object, std::uint32_t face) {
    if (object.kind != ir::ShapeKind::kMesh) return shape_bounds(scene, object);
    BoxBounds<double> box;
    const auto v = face_vertices<double>(scene.meshes[object.shape], face, {});
    for (const Vec3d p : v) box.add(p);
    return box;
}

Vec3d farthest(const BoxBounds<double>& box, Vec3d from) {
    Vec3d most;
    for (std::size_t i = 0; i < 3; ++i) {
        most[i] = std::max(std::fabs(box.lo[i] - from[i]), std::fabs(box.hi[i] - from[i]));
    }
    return most;
}

}  // namespace

double reach_of(const ir::Scene& scene, Vec3d origin, ir::ObjectId id, std::uint32_t face) {
    const ir::Object& object = scene.objects[id.value];
    if (object.kind == ir::ShapeKind::kPlane) return 0;
    const BoxBounds<double> box = own_bounds(scene, object, face);
    if (box.empty()) return 0;
    if (object.placement.count == 0) return sum_of(farthest(box, origin));
    // The shape's numbers, and the rows of the matrix times a point of the world: the first are
    // roundings in the shape's space, the second on the way to it.
    const ir::Placement& placement = scene.placements[object.placement.first];
    const Vec3d own = farthest(box, {});
    const Vec3d corner = placement.object_to_world.point(box.lo) - origin;
    const Vec3d edges = box.hi - box.lo;
    Vec3d mapped;
    Vec3d back;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            mapped[i] += std::fabs(placement.object_to_world.rows[i][j]) * own[j];
            back[i] += std::fabs(placement.object_to_world.rows[i][j]) * edges[j];
        }
    }
    return sum_of(mapped) + sum_of(corner) + sum_of(back);
}

}  // namespace cobble::renderer
