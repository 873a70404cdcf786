// SPDX-License-Identifier: MIT
#include "ir/scene/bounds.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cobble::ir {

namespace {

using math::BoxBounds;
using math::Vec3d;

void add_finite(BoxBounds<double>& box, Vec3d p) {
    if (finite(p)) box.add(p);
}

}  // namespace

BoxBounds<double> shape_bounds(const Scene& scene, const Object& object) {
    BoxBounds<double> box;
    switch (object.kind) {
        case ShapeKind::kSphere:
            for (const auto& key : scene.spheres[object.shape].keys) {
                const Vec3d r{key.radius, key.radius, key.radius};
                add_finite(box, key.center - r);
                add_finite(box, key.center + r);
            }
            break;
        case ShapeKind::kTriangle:
            for (const auto& key : scene.triangles[object.shape].keys) {
                for (const Vec3d p : key) add_finite(box, p);
            }
            break;
        case ShapeKind::kBox:
            add_finite(box, scene.boxes[object.shape].min);
            add_finite(box, scene.boxes[object.shape].max);
            break;
        case ShapeKind::kMesh: {
            const Mesh& mesh = scene.meshes[object.shape];
            // A position belongs to some six faces: looked at once.
            std::vector<std::uint8_t> used(mesh.positions.size());
            for (const auto& face : mesh.faces) {
                for (const auto& corner : face.corners) used[corner.position] = 1;
            }
            for (std::size_t i = 0; i < used.size(); ++i) {
                if (used[i] != 0) add_finite(box, mesh.positions[i]);
            }
            break;
        }
        case ShapeKind::kPlane:
            break;
    }
    return box;
}

BoxBounds<double> SceneBounds::shape(const Object& object) {
    if (object.kind != ShapeKind::kMesh) return shape_bounds(*scene_, object);
    auto& known = meshes_[object.shape];
    if (!known) known = shape_bounds(*scene_, object);
    return *known;
}

BoxBounds<double> SceneBounds::world(const Object& object) {
    const BoxBounds<double> own = shape(object);
    if (own.empty() || object.placement.count == 0) return own;
    BoxBounds<double> box;
    for (std::uint32_t k = 0; k < object.placement.count; ++k) {
        const auto& map = scene_->placements[object.placement.first + k].object_to_world;
        for (unsigned i = 0; i < 8; ++i) {
            add_finite(box, map.point({(i & 1U) != 0 ? own.hi.x : own.lo.x,
                                       (i & 2U) != 0 ? own.hi.y : own.lo.y,
                                       (i & 4U) != 0 ? own.hi.z : own.lo.z}));
        }
    }
    return box;
}

BoxBounds<double> SceneBounds::all() {
    BoxBounds<double> sum;
    for (const Object& object : scene_->objects) sum.add(world(object));
    return sum;
}

BoxBounds<double> finite_bounds(const Scene& scene) { return SceneBounds(scene).all(); }

}  // namespace cobble::ir
