// SPDX-License-Identifier: MIT
#include "ir/scene/local_origin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cobble::ir {

namespace {

using math::BoxBounds;
using math::Vec3d;

// Steps of the grid, in reaches of what is nearest.
constexpr double kReaches = 64;
// In widths of the scene: finer than that double has no digits that could be brought near.
constexpr double kFinest = 0x1p-52;

double largest(Vec3d p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); }

double distance_to_plane(const Scene& scene, const Object& object, Vec3d p) {
    const Plane& plane = scene.planes[object.shape];
    if (object.placement.count == 0) {
        return std::fabs(dot(plane.normal, p) - plane.offset) / length(plane.normal);
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = 0; k < object.placement.count; ++k) {
        const auto& map = scene.placements[object.placement.first + k].world_to_object;
        const double distance = std::fabs(dot(plane.normal, map.point(p)) - plane.offset) /
                                length(map.transposed_vector(plane.normal));
        if (distance < least) least = distance;
    }
    return least;
}

}  // namespace

Vec3d local_origin(const Scene& scene, SceneBounds& bounds) {
    const Vec3d eye = scene.camera.center;
    BoxBounds<double> all;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Object& object : scene.objects) {
        double reach = 0;
        if (object.kind == ShapeKind::kPlane) {
            reach = distance_to_plane(scene, object, eye);
        } else {
            const BoxBounds<double> box = bounds.world(object);
            if (box.empty()) continue;
            all.add(box);
            reach = std::max(largest(box.lo - eye), largest(box.hi - eye));
        }
        if (reach < nearest) nearest = reach;
    }
    const double coarse = math::grid_step(all);
    const double wanted = std::max(kReaches * nearest, kFinest * coarse);
    if (!(wanted < coarse)) return math::grid_origin(all, eye);
    double step = coarse;
    while (step * 0.5 >= wanted) step *= 0.5;
    return step < coarse ? math::nearest_on_grid(eye, step) : math::grid_origin(all, eye);
}

}  // namespace cobble::ir
