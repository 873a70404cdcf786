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

/// One line a fact, indented by the depth of the ray.
std::string pick_to_text(const PickReport& report);

/// {"cobble_pick": 1, "pixel": [x, y], "ray": {...}}: with the whole tree each ray holds "rays".
std::string pick_to_json(const PickReport& report);

}  // namespace cobble::driver
