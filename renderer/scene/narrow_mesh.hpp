// SPDX-License-Identifier: MIT
// A mesh made local and narrow at once.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/scene/shape_bounds.hpp"

namespace cobble::renderer {

/// What face_vertices() gives, for many faces: each position is narrowed once, not for each of the
/// some six faces around it. The mesh must outlive it.
template <typename T>
class NarrowMesh {
  public:
    NarrowMesh(const ir::Mesh& mesh, math::Vec3d origin) : mesh_(mesh) {
        positions_.reserve(mesh.positions.size());
        for (const math::Vec3d p : mesh.positions) {
            positions_.push_back((p - origin).template to<T>());
        }
    }
    [[nodiscard]] std::array<math::Vec3<T>, 3> vertices(std::uint32_t face) const {
        const auto& c = mesh_.faces[face].corners;
        return {positions_[c[0].position], positions_[c[1].position], positions_[c[2].position]};
    }

  private:
    const ir::Mesh& mesh_;
    std::vector<math::Vec3<T>> positions_;
};

}  // namespace cobble::renderer
