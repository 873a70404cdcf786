// SPDX-License-Identifier: MIT
#include "frontend/editor/references.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/ast/reporter.hpp"
#include "frontend/editor/materials.hpp"
#include "frontend/editor/place.hpp"
#include "frontend/lex/words.hpp"

namespace cobble::frontend::editor {
namespace {

constexpr std::string_view kNothing = "there is no label here, and no material";

/// What an offset speaks of.
struct Target {
    BlockNodeId block;  ///< whose label it is; invalid: nothing
    ByteRange origin;
    bool is_material = false;
};

Target target_at(const CheckedScene& scene, std::uint32_t offset) {
    const Place place = place_at(scene, offset);
    if (!place.block.valid()) return {};
    const ByteRange origin = scene.tokens.range(place.token);
    if (scene.ast.block(place.block).row == grammar::BlockId::kMaterialIndex) {
        const MaterialUse use = material_use(scene, place.block);
        if (use.value != place.token || use.material == CheckedScene::kNoMaterial) return {};
        return {scene.materials[use.material], origin, true};
    }
    const bool material = material_index(scene, place.block) != CheckedScene::kNoMaterial;
    if (place.is_label || (place.is_block_name && material)) {
        return {place.block, origin, material};
    }
    return {};
}

ByteRange name_range(const CheckedScene& scene, BlockNodeId id) {
    const BlockNode& block = scene.ast.block(id);
    if (block.label.valid()) return scene.tokens.range(block.label);
    return scene.tokens.range(TokenId{scene.cst.node(block.cst).first_token});
}

bool is_taken(const CheckedScene& scene, BlockNodeId id, std::string_view name) {
    const grammar::Role role = grammar::row(scene.ast.block(id).row).role;
    for (std::uint32_t i = 0; i < scene.ast.blocks.size(); ++i) {
        if (i == id.value || grammar::row(scene.ast.blocks[i].row).role != role) continue;
        if (label_text(scene, {i}) == name) return true;
    }
    return false;
}

std::string refuse_name(const CheckedScene& scene, BlockNodeId id, std::string_view name) {
    if (!is_label(name)) {
        return fmt::format(
            "{} cannot be a label: a label is a letter or underscore, then letters, digits, "
            "underscores and hyphens",
            quoted(name));
    }
    if (grammar::is_vocabulary_name(name)) {
        return fmt::format("'{}' is a word of the language", name);
    }
    if (is_taken(scene, id, name)) return fmt::format("there is another '{}' already", name);
    return {};
}

/// A block that was read in spite of its braces or place is no base for changes.
std::string refuse_block(const CheckedScene& scene, BlockNodeId id) {
    const BlockNode& block = scene.ast.block(id);
    if (block.label.valid()) return {};
    if (block.broken) return "the block has errors of its own";
    // A label that could not be read stands where the new one would.
    if (label_of(scene.tokens, scene.cst.node(block.cst)).valid()) {
        return "the block has a label that is none";
    }
    return {};
}

}  // namespace

std::optional<Definition> definition(const CheckedScene& scene, std::string_view,
                                     std::uint32_t offset) {
    const Target target = target_at(scene, offset);
    if (!target.block.valid()) return std::nullopt;
    return Definition{target.origin, bytes_of(scene, scene.ast.block(target.block).cst),
                      name_range(scene, target.block)};
}

std::vector<Reference> references(const CheckedScene& scene, std::string_view,
                                  std::uint32_t offset) {
    const Target target = target_at(scene, offset);
    if (!target.block.valid()) return {};
    std::vector<Reference> found = {{name_range(scene, target.block), true}};
    if (!target.is_material) return found;
    for (const MaterialUse& use : material_uses(scene)) {
        if (use.material == CheckedScene::kNoMaterial) continue;
        if (scene.materials[use.material] != target.block) continue;
        found.push_back({scene.tokens.range(use.value), false});
    }
    return found;
}

RenameTarget rename_target(const CheckedScene& scene, std::string_view, std::uint32_t offset) {
    const Target target = target_at(scene, offset);
    if (!target.block.valid()) return {{offset, offset}, {}, std::string(kNothing)};
    const std::string_view label = label_text(scene, target.block);
    RenameTarget result{target.origin, std::string(label), refuse_block(scene, target.block)};
    if (label.empty()) result.current = fmt::format("{}", material_index(scene, target.block));
    return result;
}

Rename rename(const CheckedScene& scene, std::string_view, std::uint32_t offset,
              std::string_view name) {
    const Target target = target_at(scene, offset);
    if (!target.block.valid()) return {{}, std::string(kNothing)};
    const std::string_view label = label_text(scene, target.block);
    if (!label.empty() && label == name) return {};
    if (std::string refusal = refuse_block(scene, target.block); !refusal.empty()) {
        return {{}, std::move(refusal)};
    }
    if (std::string refusal = refuse_name(scene, target.block, name); !refusal.empty()) {
        return {{}, std::move(refusal)};
    }
    Rename result;
    const ByteRange at = name_range(scene, target.block);
    if (label.empty()) {
        result.edits.push_back({{at.end, at.end}, fmt::format(" {}", name)});
    } else {
        result.edits.push_back({at, std::string(name)});
    }
    if (target.is_material) {
        for (const MaterialUse& use : material_uses(scene)) {
            if (use.material == CheckedScene::kNoMaterial) continue;
            if (scene.materials[use.material] != target.block) continue;
            // A number goes on meaning the material that has a label already.
            if (use.by_number && !label.empty()) continue;
            result.edits.push_back({scene.tokens.range(use.value), std::string(name)});
        }
    }
    std::ranges::sort(result.edits, {}, [](const TextEdit& edit) { return edit.span.begin; });
    return result;
}

}  // namespace cobble::frontend::editor
