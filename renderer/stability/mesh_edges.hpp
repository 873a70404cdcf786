// SPDX-License-Identifier: MIT
// Which faces of a mesh share an edge.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/scene/assets.hpp"

namespace cobble::renderer {

/// Corners are the same if they have one index in the mesh. Costs a sort of all edges, and 12 bytes
/// a face.
class MeshEdges {
  public:
    static constexpr std::uint32_t kNone = 0xffffffffU;

    explicit MeshEdges(const ir::Mesh& mesh);

    /// Every edge belongs to two faces: nothing goes in that does not come out.
    [[nodiscard]] bool closed() const { return closed_; }
    /// The face beyond the edge from `corner` (0 to 2) of `face` to the next; kNone if there is
    /// none or more than one.
    [[nodiscard]] std::uint32_t across(std::uint32_t face, std::uint32_t corner) const {
        return across_[std::size_t{3} * face + corner];
    }

  private:
    std::vector<std::uint32_t> across_;
    bool closed_ = true;
};

}  // namespace cobble::renderer
