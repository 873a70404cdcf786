// SPDX-License-Identifier: MIT
// Words shown within the text that are not in it: behind a MaterialIndex by number, the label of
// the material that it means. Input: a checked scene and its text. Output: in order of the file.
// Cost: one pass over the blocks.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"

namespace cobble::frontend::editor {

struct InlayHint {
    std::uint32_t offset;    ///< where it is shown: behind the value
    std::string text;        ///< without blanks around it
    std::uint32_t material;  ///< index into CheckedScene::materials, for whoever asks more
};

std::vector<InlayHint> inlay_hints(const CheckedScene& scene, std::string_view text);

}  // namespace cobble::frontend::editor
