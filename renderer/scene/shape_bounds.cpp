// SPDX-License-Identifier: MIT
#include "renderer/scene/shape_bounds.hpp"

#include <cmath>
#include <cstddef>

#include "ir/math/double_double.hpp"
#include "renderer/scene/rebase.hpp"

namespace cobble::renderer {

namespace {

using math::DoubleDouble;
using math::Vec3d;

double exact_dot(Vec3d a, Vec3d b, double plus) {
    const DoubleDouble sum =
        ((DoubleDouble(a.x) * DoubleDouble(b.x) + DoubleDouble(a.y) * DoubleDouble(b.y)) +
         DoubleDouble(a.z) * DoubleDouble(b.z)) +
        DoubleDouble(plus);
    return static_cast<double>(sum);
}

}  // namespace

bool flat_in_double(const std::array<math::Vec3d, 3>& v) {
    const Vec3d a = v[1] - v[0];
    const Vec3d b = v[2] - v[0];
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        size = std::fabs(a[i]) > size ? std::fabs(a[i]) : size;
        size = std::fabs(b[i]) > size ? std::fabs(b[i]) : size;
    }
    // By a power of two, so that products stay in range.
    const double scale = size < 0x1p-400 ? 0x1p400 : size > 0x1p400 ? 0x1p-400 : 1;
    return cross(a * scale, b * scale) == Vec3d{};
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
