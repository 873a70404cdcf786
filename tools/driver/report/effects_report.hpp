// SPDX-License-Identifier: MIT
// What a scene calls for, and how it would be rendered: for people and as JSON.
#pragma once

#include <string>
#include <string_view>

#include "frontend/source/source_map.hpp"
#include "ir/scene/effects.hpp"
#include "renderer/integrator/render_plan.hpp"
#include "tools/driver/report/diagnostic_json.hpp"

namespace cobble::driver {

struct EffectsReport {
    const ir::Effects& effects;
    const source::SourceMap& sources;
    std::string_view path;
    const renderer::RenderPlan* plan = nullptr;  ///< null: not asked for
};

/// A line for each effect, on or off, and under it each line of the scene that calls for it; then
/// the plan: the form of each stage and why, and the bytes of what is allocated for them.
std::string effects_to_text(const EffectsReport& report);

/// {"version": 1, "path": P, "effects": [{"name", "on", "description", "reason", "causes":
/// [{"path", "range"}]}]}. "reason" is why it is off, or that an option alone wants it; else null.
/// Ranges are those of diagnostics. With a plan also "plan": {"stages": [{"stage", "form", "why"}],
/// "columns":
/// [{"name", "bytes"}], "pictures": [{"name", "bytes"}]}.
Json effects_to_json(const EffectsReport& report);

}  // namespace cobble::driver
