// SPDX-License-Identifier: MIT
#include "renderer/scene/shape_bounds.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include "ir/math/double_double.hpp"
#include "renderer/scene/rebase.hpp"

namespace cobble::renderer {

namespace {

using math::DoubleDouble;
using math::Vec3d;

void add_finite(BoxBounds<double>& box, Vec3d p) {
    if (finite(p)) box.add(p);
}

double exact_dot(Vec3d a, Vec3d b, double plus) {
    const DoubleDouble sum =
        ((DoubleDouble(a.x) * DoubleDouble(b.x) + DoubleDouble(a.y) * DoubleDouble(b.y)) +
         DoubleDouble(a.z) * DoubleDouble(b.z)) +
        DoubleDouble(plus);
    return static_cast<double>(sum);
}

}  // namespace

BoxBounds<double> shape_bounds(const ir::Scene& scene, const ir::Object& object) {
    BoxBounds<double> box;
    switch (object.kind) {
        case ir::ShapeKind::kSphere:
            for (const auto& key : scene.spheres[object.shape].keys) {
                const Vec3d r{key.radius, key.radius, key.radius};
                add_finite(box, key.center - r);
                add_finite(box, key.center + r);
            }
            break;
        case ir::ShapeKind::kTriangle:
            for (const auto& key : scene.triangles[object.shape].keys) {
                for (const Vec3d p : key) add_finite(box, p);
            }
            break;
        case ir::ShapeKind::kBox:
            add_finite(box, scene.boxes[object.shape].min);
            add_finite(box, scene.boxes[object.shape].max);
            break;
        case ir::ShapeKind::kMesh: {
            const ir::Mesh& mesh = scene.meshes[object.shape];
            for (const auto& face : mesh.faces) {
                for (const auto& corner : face.corners) {
                    add_finite(box, mesh.positions[corner.position]);
                }
            }
            break;
        }
        case ir::ShapeKind::kPlane:
            break;
    }
    return box;
}

BoxBounds<double> finite_bounds(const ir::Scene& scene) {
    BoxBounds<double> sum;
    for (const ir::Object& object : scene.objects) {
        const BoxBounds<double> own = shape_bounds(scene, object);
        if (own.empty()) continue;
        if (object.placement.count == 0) {
            sum.add(own);
            continue;
        }
        for (std::uint32_t k = 0; k < object.placement.count; ++k) {
            const auto& map = scene.placements[object.placement.first + k].object_to_world;
            for (unsigned i = 0; i < 8; ++i) {
                add_finite(sum, map.point({(i & 1U) != 0 ? own.hi.x : own.lo.x,
                                           (i & 2U) != 0 ? own.hi.y : own.lo.y,
                                           (i & 4U) != 0 ? own.hi.z : own.lo.z}));
            }
        }
    }
    return sum;
}

PlaneKey plane_key(const ir::Scene& scene, const ir::Object& object, std::uint32_t k,
                   math::Vec3d origin) {
    const ir::Plane& plane = scene.planes[object.shape];
    if (object.placement.count == 0) {
        return {plane.normal, -exact_dot(plane.normal, origin, -plane.offset)};
    }
    // n . (W p) = offset, W p = A p + a: (A^T n) . p = offset - n . a.
    const auto map = rebased(scene.placements[object.placement.first + k].world_to_object, origin,
                             math::Vec3d{});
    const Vec3d a{map.rows[0][3], map.rows[1][3], map.rows[2][3]};
    PlaneKey key{map.transposed_vector(plane.normal), -exact_dot(plane.normal, a, -plane.offset)};
    const double size = length(key.normal);
    if (object.placement.count == 1 && size > 0) {
        key.normal = key.normal / size;
        key.offset /= size;
    }
    return key;
}

}  // namespace cobble::renderer
