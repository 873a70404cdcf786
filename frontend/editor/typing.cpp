// SPDX-License-Identifier: MIT
#include "frontend/editor/typing.hpp"

#include <algorithm>

namespace cobble::frontend::editor {
namespace {

bool has_named_members(const grammar::BlockRow& row) {
    return row.layout == grammar::Layout::kFields || row.layout == grammar::Layout::kList;
}

bool is_brace(TokenKind kind) {
    return kind == TokenKind::kOpenBrace || kind == TokenKind::kCloseBrace;
}

/// The word that the cursor is in or at the end of.
TokenId word_before(const CheckedScene& scene, std::uint32_t offset) {
    const TokenId next = token_from(scene, offset);
    if (next.value == 0) return {};
    const TokenId token{next.value - 1};
    if (is_brace(scene.tokens.kind(token)) || scene.tokens.kind(token) == TokenKind::kEndOfFile) {
        return {};
    }
    return scene.tokens.range(token).end >= offset ? token : TokenId{};
}

bool line_ends_between(const CheckedScene& scene, std::uint32_t begin, std::uint32_t end) {
    const std::string_view gap = scene.tokens.text.substr(begin, end - begin);
    return gap.find_first_of("\r\n") != std::string_view::npos;
}

const grammar::FieldRow* field_of(const CheckedScene& scene, const Typing& typing,
                                  const CstNode& member) {
    const std::string_view name = scene.tokens.text_of({member.first_token});
    const grammar::WordId word = grammar::find_word(name);
    if (const grammar::BlockRow* row = grammar::block_named(word)) {
        return row->layout == grammar::Layout::kInline ? &grammar::fields_of(row->id)[0] : nullptr;
    }
    return typing.block == nullptr ? nullptr : grammar::field_named(typing.block->id, word);
}

std::uint32_t end_of_members(const CheckedScene& scene, const CstNode& block) {
    const bool closes = scene.tokens.kind({block.end_token - 1}) == TokenKind::kCloseBrace;
    return block.end_token - (closes ? 1 : 0);
}

std::uint32_t count_values(const CheckedScene& scene, std::uint32_t begin, std::uint32_t end) {
    std::uint32_t count = 0;
    for (std::uint32_t i = begin; i < end; ++i) count += values_in(scene, {i});
    return count;
}

}  // namespace

bool Typing::wants_value() const {
    if (field == nullptr) return false;
    return values_before + values_behind < static_cast<std::uint32_t>(grammar::arity(field->type));
}

bool Typing::takes_member() const {
    if (block != nullptr && !has_named_members(*block)) return false;
    // Nothing parts the values of a field.
    if (values_behind > 0) return false;
    return !wants_value() || !on_field_line;
}

Typing typing_at(const CheckedScene& scene, std::uint32_t offset) {
    const auto size = static_cast<std::uint32_t>(scene.tokens.text.size());
    offset = std::min(offset, size);
    Typing typing;
    typing.word = word_before(scene, offset);
    typing.span = typing.word.valid() ? scene.tokens.range(typing.word) : ByteRange{offset, offset};
    const TokenId next = typing.word.valid() ? typing.word : token_from(scene, offset);
    const Gap gap = gap_before(scene, next);
    typing.around = gap.around;

    const NodeKind kind = scene.cst.kind(gap.around);
    if (kind != NodeKind::kFile) {
        const CstNode& node = scene.cst.node(gap.around);
        typing.block = grammar::find_block(scene.tokens.text_of({node.first_token}));
    }
    const bool unknown = kind != NodeKind::kFile && typing.block == nullptr;
    if (unknown || kind == NodeKind::kNameless || in_comment(scene, offset)) {
        typing.nothing = true;
        return typing;
    }
    const std::uint32_t before_end = next.value == 0 ? 0 : scene.tokens.range({next.value - 1}).end;
    const std::uint32_t behind = next.value + (typing.word.valid() ? 1 : 0);
    typing.on_field_line = !line_ends_between(scene, before_end, typing.span.begin);

    if (typing.block != nullptr && typing.block->layout == grammar::Layout::kPositional) {
        typing.field = &grammar::fields_of(typing.block->id)[0];
        const CstNode& node = scene.cst.node(gap.around);
        const TokenId brace = open_brace_of(scene.tokens, node);
        const std::uint32_t first = (brace.valid() ? brace.value : node.first_token) + 1;
        typing.values_before = count_values(scene, first, next.value);
        typing.values_behind = count_values(scene, behind, end_of_members(scene, node));
        typing.on_field_line = true;
        return typing;
    }
    if (!gap.before.valid()) return typing;
    const CstNode& member = scene.cst.node(gap.before);
    switch (scene.cst.kind(gap.before)) {
        case NodeKind::kField:
            typing.field = field_of(scene, typing, member);
            typing.values_before = count_values(scene, member.first_token + 1, next.value);
            typing.values_behind = count_values(scene, behind, member.end_token);
            break;
        case NodeKind::kBlock: {
            // Behind a name without its {, on the same line: a label may stand there, or a brace.
            const bool complete = member.unclosed == 0 && next.value >= member.end_token &&
                                  open_brace_of(scene.tokens, member).valid();
            typing.nothing = !complete && typing.on_field_line;
            break;
        }
        case NodeKind::kUnknown:
        case NodeKind::kNameless:
            typing.nothing = typing.on_field_line && next.value <= member.end_token &&
                             scene.cst.kind(gap.before) == NodeKind::kUnknown;
            break;
        default:
            break;
    }
    return typing;
}

}  // namespace cobble::frontend::editor
