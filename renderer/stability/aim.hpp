// SPDX-License-Identifier: MIT
// The points of an object where a ray tracer errs first.
#pragma once

#include <cstdint>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/stability/mesh_edges.hpp"

namespace cobble::renderer {

/// World points of one object, as many as are asked for, the same on every machine: point `i` is a
/// function of the scene, the object and `i`. By turns a vertex, a point of an edge, one of a face,
/// and one of the outline that `eye` sees: of a mesh a point of an edge between a face that shows
/// `eye` its front and one that does not, if one is found soon. Of a sphere a point just inside the
/// outline, one of the side that is seen, and one of all; of a plane points all around the foot of
/// `eye`, ever further out. Things that move are taken as they stand when the shutter opens. May be
/// anything, NaN included, for an object without faces or a matrix without inverse.
class AimPoints {
  public:
    /// `edges` of the mesh, if the object is one and outlines are wanted; all must outlive this.
    AimPoints(const ir::Scene& scene, ir::ObjectId object, math::Vec3d eye,
              const MeshEdges* edges = nullptr);

    [[nodiscard]] math::Vec3d point(std::uint32_t i) const;

    /// Whether that is one of a face or of the side that is seen, and so not at an outline on
    /// purpose.
    static bool is_inner(std::uint32_t i);

  private:
    const ir::Scene* scene_;
    ir::ObjectId id_;
    math::Vec3d eye_;
    const MeshEdges* edges_;
};

}  // namespace cobble::renderer
