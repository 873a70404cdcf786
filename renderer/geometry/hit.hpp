// SPDX-License-Identifier: MIT
// Where a ray meets the scene, and what the surface is like there.
#pragma once

#include <cstdint>

#include "ir/math/vec.hpp"
#include "ir/scene/ids.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::renderer {

/// The answer to a ray: the smallest (t, object, face) of all that it meets, the same whatever the
/// tree, compiler or machine.
template <typename T>
struct Hit {
    T t = 0;
    ir::ObjectId object;     ///< invalid: nothing was hit
    std::uint32_t face = 0;  ///< of a mesh; of a box 2 axis + (1 on the upper side); else 0
    T u = 0;                 ///< weight of a triangle's second vertex; else 0
    T v = 0;                 ///< weight of its third vertex; else 0

    [[nodiscard]] explicit operator bool() const { return object.valid(); }
};

/// What shading knows of a point. Vectors are in world space, positions local (world minus
/// PreparedScene::origin).
template <typename T>
struct SurfacePoint {
    math::Vec3<T> position;
    /// Unit; outwards for spheres and boxes, as wound (counter-clockwise) for triangles, as written
    /// for planes. Never flipped toward the viewer.
    math::Vec3<T> geometric_normal;
    /// Unit; a mesh's interpolated normal, else the geometric one's bits.
    math::Vec3<T> shading_normal;
    /// If has_uv: texture coordinates, and how the point moves with each of them (not unit, not
    /// perpendicular). has_tangents is false, and they are zero, where uv are missing or
    /// degenerate: take any tangent then.
    math::Vec2<T> uv;
    math::Vec3<T> dp_du, dp_dv;
    bool has_uv = false;
    bool has_tangents = false;
    /// Bound on the distance of `position` from the surface, along the geometric normal, and of
    /// what a test of the same surface from there may err.
    T error = 0;
    ir::ShapeKind kind = ir::ShapeKind::kSphere;
    ir::ObjectId object;
    std::uint32_t face = 0;
    ir::MaterialId material;
};

}  // namespace cobble::renderer
