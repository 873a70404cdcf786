// SPDX-License-Identifier: MIT
// The part of completion.hpp about values that are being written.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/editor/completion.hpp"
#include "frontend/editor/row_words.hpp"
#include "frontend/editor/typing.hpp"

namespace cobble::frontend::editor {

using grammar::BlockRow;
using grammar::FieldRow;
using grammar::Layout;

Signature signature(const CheckedScene& scene, std::string_view, std::uint32_t offset) {
    const Typing typing = typing_at(scene, offset);
    if (typing.nothing || typing.field == nullptr) return {};
    const FieldRow& row = *typing.field;
    const auto due = static_cast<std::uint32_t>(grammar::arity(row.type));
    if (typing.values_before >= due) {
        // Behind the last value the field is done, unless another number is being written there:
        // that is one too many, and not the name of the next member.
        if (!typing.word.valid() || !typing.on_field_line) return {};
        if (scene.tokens.kind(typing.word) != TokenKind::kNumber) return {};
    }

    Signature result;
    result.found = true;
    const BlockRow& block = grammar::row(row.block);
    const bool named = block.layout == Layout::kFields || block.layout == Layout::kList;
    result.label = named ? row.name : block.name;
    for (const std::string_view component : components(row)) {
        result.label += ' ';
        const auto begin = static_cast<std::uint32_t>(result.label.size());
        result.label += component;
        result.parameters.push_back({begin, static_cast<std::uint32_t>(result.label.size())});
        result.components.emplace_back(component);
    }
    result.active = std::min(typing.values_before, due - 1);
    result.documentation = fmt::format("{}\n\n{}", row.doc, value_words(row));
    return result;
}

}  // namespace cobble::frontend::editor
