// SPDX-License-Identifier: MIT
#include "frontend/editor/hover.hpp"

#include <fmt/format.h>

#include <utility>

#include "frontend/editor/materials.hpp"
#include "frontend/editor/place.hpp"
#include "frontend/editor/readings.hpp"
#include "frontend/editor/row_words.hpp"

namespace cobble::frontend::editor {
namespace {

using grammar::BlockRow;
using grammar::FieldRow;
using grammar::ValueType;

std::string code_block(std::string_view scene_text) {
    return fmt::format("```cobble\n{}\n```", scene_text);
}

bool has_names(const BlockRow& row) {
    return row.layout == grammar::Layout::kFields || row.layout == grammar::Layout::kList;
}

/// "`radius` of Sphere", or "MaterialIndex" for a block that is its own field.
std::string field_title(const FieldRow& row) {
    const BlockRow& block = grammar::row(row.block);
    return has_names(block) ? fmt::format("`{}` of {}", row.name, block.name)
                            : fmt::format("`{}`", block.name);
}

void add(std::vector<std::string>& paragraphs, std::string text) {
    if (!text.empty()) paragraphs.push_back(std::move(text));
}

/// Which material it is, and what it is like.
void add_material(const CheckedScene& scene, std::uint32_t material,
                  std::vector<std::string>& paragraphs) {
    add(paragraphs,
        fmt::format("{}{}", material_title(scene, material),
                    scene.ast.block(scene.materials[material]).broken ? ", which has errors" : ""));
    const std::string summary = material_summary(scene, material);
    add(paragraphs,
        summary.empty() ? "It has the defaults of every field." : fmt::format("`{}`", summary));
}

/// What this very block is, beside what its name means.
void add_particulars(const CheckedScene& scene, BlockNodeId id,
                     std::vector<std::string>& paragraphs) {
    if (grammar::row(scene.ast.block(id).row).role == grammar::Role::kLight) {
        add(paragraphs, light_sentence(scene, id));
    }
    const std::uint32_t index = material_index(scene, id);
    if (index != CheckedScene::kNoMaterial) add_material(scene, index, paragraphs);
    if (id.value >= scene.material_of_block.size()) return;
    const std::uint32_t material = scene.material_of_block[id.value];
    if (material == CheckedScene::kNoMaterial) return;
    add(paragraphs, fmt::format("It is made of {}.", material_title(scene, material)));
}

Hover block_hover(const CheckedScene& scene, const Place& place) {
    const BlockRow& row = grammar::row(scene.ast.block(place.block).row);
    Hover result{scene.tokens.range(place.token), {}, {}};
    if (place.is_label) {
        result.title = fmt::format("{} `{}`", row.name, scene.tokens.word_of(place.token));
        add_particulars(scene, place.block, result.paragraphs);
        if (result.paragraphs.empty()) add(result.paragraphs, std::string(row.doc));
        return result;
    }
    result.title = fmt::format("`{}`", row.name);
    add_particulars(scene, place.block, result.paragraphs);
    for (std::string& text : block_paragraphs(row)) add(result.paragraphs, std::move(text));
    return result;
}

/// Which value of its field a token is; for a #rrggbb, the first of three.
std::uint32_t component_of(const CheckedScene& scene, const FieldNode& field, TokenId token) {
    const auto values = scene.ast.values_of(field);
    for (std::uint32_t i = 0; i < values.size(); ++i) {
        if (values[i].token == token) return i;
    }
    return static_cast<std::uint32_t>(values.size());
}

Hover value_hover(const CheckedScene& scene, const Place& place) {
    const FieldNode& field = *place.field;
    const FieldRow& row = grammar::row(field.row);
    Hover result{scene.tokens.range(place.token), field_title(row), {}};
    const std::uint32_t component = component_of(scene, field, place.token);
    if (field.broken || component >= field.value_count) {
        add(result.paragraphs, std::string(row.doc));
        add(result.paragraphs, value_words(row));
        return result;
    }
    if (row.type == ValueType::kMaterialRef) {
        const MaterialUse use = material_use(scene, place.block);
        if (use.material != CheckedScene::kNoMaterial) {
            add_material(scene, use.material, result.paragraphs);
        } else {
            add(result.paragraphs, "There is no such material.");
        }
        return result;
    }
    if (grammar::is_word(row.type)) {
        add(result.paragraphs, std::string(row.doc));
        return result;
    }
    const bool hex = scene.tokens.kind(place.token) == TokenKind::kColor;
    if (field.value_count > 1 && !hex) {
        result.title = fmt::format("{} of {}", components(row)[component], result.title);
    }
    if (!hex) add(result.paragraphs, number_reading(scene, field, component));
    for (std::string& text : field_readings(scene, field)) add(result.paragraphs, std::move(text));
    if (hex || field.value_count > 1) add(result.paragraphs, std::string(value_doc(row)));
    return result;
}

Hover field_hover(const CheckedScene& scene, const Place& place) {
    const FieldRow& row = grammar::row(place.field->row);
    Hover result{scene.tokens.range(place.token), field_title(row), field_paragraphs(row)};
    if (place.field->broken) return result;
    // What is in the file goes before the example of what could be.
    for (std::string& text : field_readings(scene, *place.field)) {
        result.paragraphs.insert(result.paragraphs.end() - 1, std::move(text));
    }
    return result;
}

}  // namespace

std::vector<std::string> block_paragraphs(const BlockRow& row) {
    std::vector<std::string> paragraphs = {std::string(row.doc)};
    add(paragraphs, parents_words(row.id));
    add(paragraphs, members_words(row.id));
    std::string list;
    for (const FieldRow& field : grammar::fields_of(row.id)) {
        if (!list.empty()) list += '\n';
        list += has_names(row) ? fmt::format("- `{}`: {}", field.name, value_words(field))
                               : value_words(field);
    }
    add(paragraphs, std::move(list));
    add(paragraphs, code_block(example_block(row.id)));
    return paragraphs;
}

std::vector<std::string> field_paragraphs(const FieldRow& row) {
    std::vector<std::string> paragraphs = {std::string(row.doc), value_words(row)};
    const BlockRow& block = grammar::row(row.block);
    add(paragraphs,
        code_block(has_names(block) ? sample_field(row).plain : sample_block(block.id).plain));
    return paragraphs;
}

std::optional<Hover> hover(const CheckedScene& scene, std::string_view, std::uint32_t offset) {
    const Place place = place_at(scene, offset);
    if (!place.token.valid() || !place.block.valid()) return std::nullopt;
    if (place.is_block_name || place.is_label) return block_hover(scene, place);
    if (place.field == nullptr) return std::nullopt;
    return place.is_field_name ? field_hover(scene, place) : value_hover(scene, place);
}

}  // namespace cobble::frontend::editor
