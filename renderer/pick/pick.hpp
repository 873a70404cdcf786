// SPDX-License-Identifier: MIT
// What made a pixel.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/settings.hpp"

namespace cobble::renderer {

/// One ray of the tree behind a pixel. Children are the rays that it sent on.
struct PickNode {
    enum class Kind : std::uint8_t { kCamera, kReflected, kRefracted };
    struct LightSeen {
        ir::LightId light;
        bool visible = false;
        ir::Color contribution;
    };

    Kind kind = Kind::kCamera;
    std::uint32_t depth = 0;
    bool hit = false;
    math::Vec3d origin, direction;
    double t = 0;  ///< world units along the unit direction
    math::Vec3d position, normal, geometric_normal;
    ir::ObjectId object;
    std::uint32_t face = 0;  ///< of a mesh
    ir::MaterialId material;
    ir::Color color;  ///< what this ray brought back
    std::vector<LightSeen> lights;
    std::vector<std::uint32_t> children;  ///< into PickTree::nodes
};

struct PickTree {
    std::vector<PickNode> nodes;  ///< nodes[0] is the camera ray
    std::uint64_t rays = 0;       ///< followed, with those that are no nodes
    bool complete = true;         ///< no ray is missing from the colors
};

/// Rays beyond this many are no nodes of the tree, though they are followed for the colors: a deep
/// bounce limit between two panes of glass has more of them than anybody reads.
inline constexpr std::uint32_t kMostPickNodes = 65536;

/// Rays beyond this many are not followed: all that 20 bounces in glass make, some seconds.
inline constexpr std::uint32_t kMostPickRays = 1U << 21U;

/// The ray through the centre of pixel (x, y), y from the top, with no effect sampled, in the
/// settings' precision: what a picture in that precision shows.
PickTree pick(const ir::Scene& scene, const Settings& settings, std::uint32_t x, std::uint32_t y);

}  // namespace cobble::renderer
