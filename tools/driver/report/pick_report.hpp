// SPDX-License-Identifier: MIT
// What made a pixel, for people and as JSON.
#pragma once

#include <cstdint>
#include <string>

#include "frontend/source/source_map.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/pick/pick.hpp"

namespace cobble::driver {

struct PickReport {
    const renderer::PickTree& tree;
    const ir::Scene& scene;
    const source::SourceMap& sources;
    std::uint32_t x = 0, y = 0;
    bool whole_tree = false;  ///< not the camera ray alone
};

/// Rays beyond these are counted, not shown: a full tree of 11 bounces, and no deeper than the
/// indentation stays within a screen. They keep what is printed within some ten megabytes.
inline constexpr std::uint32_t kMostShownRays = 4096;
inline constexpr std::uint32_t kMostShownDepth = 64;

/// What to say about a colour that lacks rays, or "".
std::string incomplete_text(const renderer::PickTree& tree);

/// One line a fact, indented by the depth of the ray.
std::string pick_to_text(const PickReport& report);

/// {"cobble_pick": 1, "pixel": [x, y], "complete": true, "ray": {...}}: with the whole tree each
/// ray holds "rays", and "rays_left_out" counts those that are not shown.
std::string pick_to_json(const PickReport& report);

}  // namespace cobble::driver
