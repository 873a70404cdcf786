// SPDX-License-Identifier: MIT
#include "frontend/editor/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "frontend/source/utf8.hpp"

namespace cobble::frontend::editor {
namespace {

using Labels = std::unordered_map<std::string_view, std::uint32_t>;

Labels labels_of(const CheckedScene& scene) {
    Labels labels;
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
        const std::string_view label = label_text(scene, scene.materials[i]);
        if (!label.empty()) labels.try_emplace(label, i);
    }
    return labels;
}

MaterialUse read_use(const CheckedScene& scene, BlockNodeId id, const Labels& labels) {
    MaterialUse use{id, {}, CheckedScene::kNoMaterial, false};
    const BlockNode& block = scene.ast.block(id);
    if (block.row != grammar::BlockId::kMaterialIndex || block.broken) return use;
    const auto fields = scene.ast.fields_of(id);
    if (fields.empty() || fields[0].broken || fields[0].value_count != 1) return use;
    const Value& value = scene.ast.values_of(fields[0])[0];
    use.value = value.token;
    use.by_number = scene.tokens.kind(value.token) == TokenKind::kNumber;
    if (use.by_number) {
        // The binder has seen to it that it is a whole number.
        if (value.number >= 0 && value.number < static_cast<double>(scene.materials.size())) {
            use.material = static_cast<std::uint32_t>(value.number);
        }
    } else if (const auto found = labels.find(scene.tokens.word_of(value.token));
               found != labels.end()) {
        use.material = found->second;
    }
    return use;
}

/// Paths may hold anything: what is no UTF-8 becomes U+FFFD, and nothing ends a code span.
std::string shown(std::string_view word) {
    std::string text;
    while (!word.empty()) {
        const std::size_t length = source::utf8_length(word);
        if (length == 0) {
            text += "\xEF\xBF\xBD";
        } else {
            text += word[0] == '`' ? std::string_view("'") : word.substr(0, length);
        }
        word.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return text;
}

}  // namespace

std::vector<MaterialUse> material_uses(const CheckedScene& scene) {
    const Labels labels = labels_of(scene);
    std::vector<MaterialUse> uses;
    for (std::uint32_t i = 0; i < scene.ast.blocks.size(); ++i) {
        if (scene.ast.blocks[i].row != grammar::BlockId::kMaterialIndex) continue;
        const MaterialUse use = read_use(scene, {i}, labels);
        if (use.value.valid()) uses.push_back(use);
    }
    return uses;
}

MaterialUse material_use(const CheckedScene& scene, BlockNodeId block) {
    return read_use(scene, block, labels_of(scene));
}

std::uint32_t material_index(const CheckedScene& scene, BlockNodeId block) {
    const auto found = std::ranges::lower_bound(scene.materials, block);
    if (found == scene.materials.end() || *found != block) return CheckedScene::kNoMaterial;
    return static_cast<std::uint32_t>(found - scene.materials.begin());
}

std::string_view label_text(const CheckedScene& scene, BlockNodeId block) {
    const TokenId label = scene.ast.block(block).label;
    return label.valid() ? scene.tokens.word_of(label) : std::string_view{};
}

std::string material_title(const CheckedScene& scene, std::uint32_t material) {
    const std::string_view label = label_text(scene, scene.materials[material]);
    return label.empty() ? fmt::format("material {}", material)
                         : fmt::format("material {}, `{}`", material, label);
}

std::string material_summary(const CheckedScene& scene, std::uint32_t material) {
    // Enough to tell materials apart.
    constexpr int kMost = 4;
    std::string summary;
    int count = 0;
    for (const FieldNode& field : scene.ast.fields_of(scene.materials[material])) {
        if (field.broken) continue;
        if (!summary.empty()) summary += ", ";
        if (++count > kMost) return summary + "...";
        summary += fmt::format("{} {}", grammar::row(field.row).name, values_text(scene, field));
    }
    return summary;
}

std::string values_text(const CheckedScene& scene, const FieldNode& field) {
    // A path that is longer tells no more on one line.
    constexpr std::size_t kLongest = 60;
    std::string text;
    TokenId last;
    for (const Value& value : scene.ast.values_of(field)) {
        if (value.token == last) continue;
        last = value.token;
        if (!text.empty()) text += ' ';
        const std::string_view word = scene.tokens.text_of(value.token);
        text += word.size() <= kLongest ? shown(word) : "...";
    }
    return text;
}

}  // namespace cobble::frontend::editor
