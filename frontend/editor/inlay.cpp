// SPDX-License-Identifier: MIT
#include "frontend/editor/inlay.hpp"

#include "frontend/editor/materials.hpp"

namespace cobble::frontend::editor {

std::vector<InlayHint> inlay_hints(const CheckedScene& scene, std::string_view) {
    std::vector<InlayHint> hints;
    for (const MaterialUse& use : material_uses(scene)) {
        if (!use.by_number || use.material == CheckedScene::kNoMaterial) continue;
        const std::string_view label = label_text(scene, scene.materials[use.material]);
        if (label.empty()) continue;
        hints.push_back({scene.tokens.range(use.value).end, std::string(label), use.material});
    }
    return hints;
}

}  // namespace cobble::frontend::editor
