// SPDX-License-Identifier: MIT
// How a scene stands up to float, for people and as JSON.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "frontend/source/source_map.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/stability/stability.hpp"

namespace cobble::driver {

struct StabilityReport {
    const renderer::Stability& stability;
    const ir::Scene& scene;
    const source::SourceMap& sources;
    std::string_view path;
    std::uint32_t width = 0, height = 0;
};

/// A table of objects, worst first, cut after those that matter; the first fault of each that has
/// one; notes; a sentence to sum up.
std::string stability_to_text(const StabilityReport& report);

/// {"cobble_stability": 1, "size": [w, h], "rays": N, "clean": B, "objects": [...],
/// "notes": [...]}: every object, worst first.
std::string stability_to_json(const StabilityReport& report);

}  // namespace cobble::driver
