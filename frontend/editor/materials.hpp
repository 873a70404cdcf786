// SPDX-License-Identifier: MIT
// Which material a MaterialIndex means, as the checker finds it: by number among the children of
// Materials, or by the first of them that has the label.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"

namespace cobble::frontend::editor {

/// One MaterialIndex whose value can be read.
struct MaterialUse {
    BlockNodeId block;       ///< the MaterialIndex
    TokenId value;           ///< a number or a label
    std::uint32_t material;  ///< index into CheckedScene::materials, or kNoMaterial
    bool by_number;
};

/// Every one of them, in order. Cost: one pass over the blocks and one hash look-up each.
std::vector<MaterialUse> material_uses(const CheckedScene& scene);

/// The same for one; a block that is none, or has no readable value, has no value token either.
MaterialUse material_use(const CheckedScene& scene, BlockNodeId block);

/// The index of a block among the materials, or kNoMaterial.
std::uint32_t material_index(const CheckedScene& scene, BlockNodeId block);

/// The label of a block, or an empty view.
std::string_view label_text(const CheckedScene& scene, BlockNodeId block);

/// "material 1, `glass`".
std::string material_title(const CheckedScene& scene, std::uint32_t material);

/// Its fields as they stand in the file: "diffuseColor 0 0 0, refractionIndex 1.5".
std::string material_summary(const CheckedScene& scene, std::uint32_t material);

/// The values of a field as they stand in the file, with single blanks, for people: what is long is
/// cut short, what is no UTF-8 becomes U+FFFD, and a backquote becomes a quote.
std::string values_text(const CheckedScene& scene, const FieldNode& field);

}  // namespace cobble::frontend::editor
