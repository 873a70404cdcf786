// SPDX-License-Identifier: MIT
#include "frontend/check/context.hpp"

#include <array>
#include <utility>

#include "frontend/ast/edits.hpp"
#include "frontend/lex/invisible.hpp"
#include "frontend/names/dialects.hpp"
#include "frontend/names/suggest.hpp"

namespace cobble::frontend {
source::Span CheckContext::span(TokenId token) const { return span(token, token); }

source::Span CheckContext::span(TokenId first, TokenId last) const {
    return {scene.source, tokens().range(first).begin, tokens().range(last).end};
}

source::Span CheckContext::name_span(BlockNodeId id) const {
    return span(TokenId{scene.cst.node(block(id).cst).first_token});
}

source::Span CheckContext::name_span(const FieldNode& field) const {
    return span(TokenId{scene.cst.node(field.cst).first_token});
}

source::Span CheckContext::value_span(const FieldNode& field) const {
    const auto values = ast().values_of(field);
    return values.empty() ? name_span(field) : span(values.front().token, values.back().token);
}

source::Span CheckContext::removal_span(NodeId node) const {
    const CstNode& record = scene.cst.node(node);
    const ByteRange range =
        removal_range(tokens(), TokenId{record.first_token}, TokenId{record.end_token - 1});
    return {scene.source, range.begin, range.end};
}

std::string CheckContext::shown(source::Span span) const {
    // No number that means something needs more digits.
    constexpr std::size_t kLongest = 40;
    const std::string_view whole = text(span);
    if (whole.size() <= kLongest) return std::string(whole);
    return std::string(whole.substr(0, kLongest)) + "...";
}

bool CheckContext::reliable(BlockNodeId id) const {
    if (!ast().structure_broken) return true;
    const CstNode& node = scene.cst.node(block(id).cst);
    if (node.has_error != 0 || node.unclosed != 0) return false;
    // What stands behind its closing brace may have been meant to stand before it.
    if (node.end_node >= scene.cst.nodes.size()) return true;
    const NodeKind next = scene.cst.kind(NodeId{node.end_node});
    return next == NodeKind::kBlock || next == NodeKind::kField;
}

bool CheckContext::is_strange(BlockNodeId parent, NodeId member) const {
    switch (scene.cst.kind(member)) {
        case NodeKind::kNumbers:
            return false;
        case NodeKind::kBlock:
        case NodeKind::kField:
            break;
        default:
            return true;
    }
    const std::string_view word = first_word(member);
    if (const grammar::BlockRow* row = grammar::find_block(word)) {
        return parent.valid() ? !grammar::may_stand_in(row->id, block(parent).row)
                              : !grammar::may_stand_at_top(row->id);
    }
    return !parent.valid() || grammar::find_field(block(parent).row, word) == nullptr;
}

bool CheckContext::has_surplus(BlockNodeId parent, NodeId member) const {
    const CstNode& node = scene.cst.node(member);
    if (!parent.valid() || scene.cst.kind(member) != NodeKind::kField || node.has_error == 0) {
        return false;
    }
    const grammar::FieldRow* row = grammar::find_field(block(parent).row, first_word(member));
    const auto values = node.end_token - node.first_token - 1;
    return row != nullptr && values > static_cast<std::uint32_t>(grammar::arity(row->type));
}

std::uint32_t CheckContext::strange_members(BlockNodeId id) const {
    const NodeId parent = node_of(id);
    std::uint32_t count = 0;
    for (NodeId child = scene.cst.first_child(parent); child.valid();
         child = scene.cst.next_child(parent, child)) {
        if (is_strange(id, child)) ++count;
    }
    return count;
}

bool CheckContext::explained(BlockNodeId id, std::string_view wanted) const {
    const NodeId parent = node_of(id);
    const std::string_view place = id.valid() ? name(id) : std::string_view{};
    const std::array<std::string_view, 1> candidates = {wanted};
    for (NodeId child = scene.cst.first_child(parent); child.valid();
         child = scene.cst.next_child(parent, child)) {
        const std::string_view word = first_word(child);
        // `angle { 40 }`, which is said to have no braces.
        if (word == wanted && scene.cst.kind(child) == NodeKind::kBlock) return true;
        if (!is_strange(id, child)) {
            if (has_surplus(id, child)) return true;
            continue;
        }
        const NodeKind kind = scene.cst.kind(child);
        if (kind == NodeKind::kStrayValue || kind == NodeKind::kNameless) return true;
        const DialectWord* entry = find_dialect_word(word, place);
        if (entry != nullptr && entry->modern == wanted) return true;
        if (visible_name(word) == wanted) return true;
        if (!nearest_name(word, candidates).empty()) return true;
        if (grammar::find_block(word) == nullptr && begins_like(child, wanted)) return true;
    }
    return false;
}

bool CheckContext::begins_like(NodeId unknown, std::string_view wanted) const {
    const grammar::BlockRow* row = grammar::find_block(wanted);
    const NodeId member = scene.cst.first_child(unknown);
    if (row == nullptr || !member.valid()) return false;
    const std::string_view word = first_word(member);
    if (grammar::find_field(row->id, word) != nullptr) return true;
    const grammar::BlockRow* inner = grammar::find_block(word);
    return inner != nullptr && grammar::may_stand_in(inner->id, row->id);
}

source::Diagnostic& CheckContext::report(const source::DiagnosticCode& code, source::Span span,
                                         std::string message) {
    source::Diagnostic diagnostic{&code, code.severity, std::move(message), span, {}, {}, {}};
    std::size_t& count = counts_[static_cast<std::size_t>(code.severity)];
    if (++count > source::kMostFindings) {
        spare_ = std::move(diagnostic);
        return spare_;
    }
    return found.emplace_back(std::move(diagnostic));
}

}  // namespace cobble::frontend
