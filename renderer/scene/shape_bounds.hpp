// SPDX-License-Identifier: MIT
// Shapes of ir::Scene made local and narrow, the same wherever it is done, and their extents.
#pragma once

#include <array>
#include <cstdint>

#include "ir/math/vec.hpp"
#include "ir/scene/bounds.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/geometry/primitives.hpp"

namespace cobble::renderer {

template <typename T>
std::array<math::Vec3<T>, 3> narrow_vertices(const std::array<math::Vec3d, 3>& v,
                                             math::Vec3d origin) {
    return {(v[0] - origin).template to<T>(), (v[1] - origin).template to<T>(),
            (v[2] - origin).template to<T>()};
}

template <typename T>
std::array<math::Vec3<T>, 3> face_vertices(const ir::Mesh& mesh, std::uint32_t face,
                                           math::Vec3d origin) {
    const auto& c = mesh.faces[face].corners;
    return narrow_vertices<T>({mesh.positions[c[0].position], mesh.positions[c[1].position],
                               mesh.positions[c[2].position]},
                              origin);
}

template <typename T>
SphereKey<T> narrow_sphere(const ir::Sphere::Key& key, math::Vec3d origin) {
    return {(key.center - origin).template to<T>(), static_cast<T>(key.radius)};
}

template <typename T>
BoxBounds<T> narrow_box(const ir::Box& box, math::Vec3d origin) {
    return {(box.min - origin).template to<T>(), (box.max - origin).template to<T>()};
}

using ir::shape_bounds;

/// Without an area to the last digit of double. As those who check a mesh reckon, so that a face is
/// told of by one of us.
bool flat_in_double(const std::array<math::Vec3d, 3>& v);

/// The plane of `object` at its key `k` (0 if it has none), local to `origin`.
PlaneKey plane_key(const ir::Scene& scene, const ir::Object& object, std::uint32_t k,
                   math::Vec3d origin);

}  // namespace cobble::renderer
