// SPDX-License-Identifier: MIT
// What preparing a scene for the renderer cost, in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/source/diagnostic.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/scene/preparation_note.hpp"
#include "renderer/settings.hpp"
#include "tools/driver/report/diagnostic_json.hpp"
#include "tools/driver/report/positions.hpp"

namespace cobble::driver {

std::string_view kind_name(renderer::PreparationNote::Kind kind);

/// One sentence; `precision` is "float" or "double", as the scene was prepared.
std::string note_text(const renderer::PreparationNote& note, const ir::Scene& scene,
                      Positions& positions, std::string_view precision);

/// "path:line:column: warning: SENTENCE" for each, in lines; of many the first, and how many more.
std::string notes_to_text(const std::vector<renderer::PreparationNote>& notes,
                          const ir::Scene& scene, Positions& positions, std::string_view precision);

/// [{"kind", "object", "count": of its faces, "message": the sentence}].
Json notes_to_json(const std::vector<renderer::PreparationNote>& notes, const ir::Scene& scene,
                   Positions& positions, std::string_view precision);

/// "float" or "double": the numbers in which a scene is rendered under these settings.
std::string_view prepared_in(const ir::Scene& scene, const renderer::Settings& settings);

/// Those that the checker says nothing of: it knows triangles and faces without area, and what it
/// says of an object's precision is among `diagnostics`.
std::vector<renderer::PreparationNote> without_checked(
    const std::vector<renderer::PreparationNote>& notes, const ir::Scene& scene,
    const std::vector<source::Diagnostic>& diagnostics);

}  // namespace cobble::driver
