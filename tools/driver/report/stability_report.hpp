// SPDX-License-Identifier: MIT
// How scenes stand up to float, for people and as JSON.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "frontend/source/source_map.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/stability/stability.hpp"
#include "tools/driver/report/diagnostic_json.hpp"
#include "tools/driver/report/reporter.hpp"

namespace cobble::driver {

struct StabilityReport {
    const renderer::Stability& stability;
    const ir::Scene& scene;
    const source::SourceMap& sources;
    std::string_view path;
    std::uint32_t width = 0, height = 0;
};

/// The objects with faults, each with its line; a table of objects, worst first, cut after those
/// that matter; how much precision is left; notes; a sentence to sum up.
std::string stability_to_text(const StabilityReport& report, const ReportStyle& style);

/// "PATH: sound, 5073 rays, a pixel is 2.5e+04 steps of float at least", in one line.
std::string stability_line(const StabilityReport& report);

/// {"cobble_stability": 1, "path": P, "size": [w, h], "rays": N, "clean": B, "complete": B,
/// "precision": {"nearest", "farthest", "worst"}, "primitive_changes": {...}, "objects": [...],
/// "notes": [...]}: every object, worst first.
Json stability_to_json(const StabilityReport& report);

}  // namespace cobble::driver
