// SPDX-License-Identifier: MIT
#include "renderer/stability/mesh_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cobble::renderer {

MeshEdges::MeshEdges(const ir::Mesh& mesh) : across_(3 * mesh.faces.size(), kNone) {
    struct Edge {
        std::uint32_t low, high;  ///< corners
        std::uint32_t slot;       ///< into across_
    };
    std::vector<Edge> edges;
    edges.reserve(across_.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.faces[f].corners[k].position;
            const std::uint32_t b = mesh.faces[f].corners[(k + 1) % 3].position;
            edges.push_back({std::min(a, b), std::max(a, b), 3 * f + k});
        }
    }
    const auto ends = [](const Edge& e) { return std::pair(e.low, e.high); };
    std::sort(edges.begin(), edges.end(), [&ends](const Edge& a, const Edge& b) {
        return std::pair(ends(a), a.slot) < std::pair(ends(b), b.slot);
    });
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && ends(edges[end]) == ends(edges[i])) ++end;
        if (end - i == 2) {
            across_[edges[i].slot] = edges[i + 1].slot / 3;
            across_[edges[i + 1].slot] = edges[i].slot / 3;
        } else {
            closed_ = false;
        }
        i = end;
    }
}

}  // namespace cobble::renderer
