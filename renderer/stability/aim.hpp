// SPDX-License-Identifier: MIT
// The points of an object where a ray tracer errs first.
#pragma once

#include <cstdint>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::renderer {

/// World points of one object, as many as are asked for, the same on every machine: point `i` is a
/// function of the scene, the object and `i`. By turns a vertex, a point of an edge and one of a
/// face; of a sphere a point just inside the outline that `eye` sees, one of the side it sees, and
/// one of all; of a plane points all around the foot of `eye`, ever further out. Things that move
/// are taken as they stand when the shutter opens. May be anything, NaN included, for an object
/// without faces or a matrix without inverse.
class AimPoints {
  public:
    AimPoints(const ir::Scene& scene, ir::ObjectId object, math::Vec3d eye);

    [[nodiscard]] math::Vec3d point(std::uint32_t i) const;

  private:
    const ir::Scene* scene_;
    ir::ObjectId id_;
    math::Vec3d eye_;
};

}  // namespace cobble::renderer
