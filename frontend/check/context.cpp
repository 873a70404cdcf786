// SPDX-License-Identifier: MIT
#include "frontend/check/context.hpp"

#include <array>
#include <utility>

#include "frontend/names/dialects.hpp"
#include "frontend/names/suggest.hpp"

namespace cobble::frontend {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool ends_line(char c) { return c == '\n' || c == '\r'; }

}  // namespace

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
    const std::string_view text = tokens().text;
    source::Span span = this->span(TokenId{record.first_token}, TokenId{record.end_token - 1});
    std::uint32_t begin = span.begin;
    std::uint32_t end = span.end;
    while (begin > 0 && is_blank(text[begin - 1])) --begin;
    while (end < text.size() && is_blank(text[end])) ++end;
    const bool starts = begin == 0 || ends_line(text[begin - 1]);
    const bool stops = end == text.size() || ends_line(text[end]);
    if (starts && stops) {
        if (end < text.size()) end += text.substr(end, 2) == "\r\n" ? 2 : 1;
        return {span.source, begin, end};
    }
    return {span.source, starts ? span.begin : begin, starts ? end : span.end};
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
        if (!is_strange(id, child)) continue;
        const NodeKind kind = scene.cst.kind(child);
        if (kind == NodeKind::kStrayValue || kind == NodeKind::kNameless) return true;
        const std::string_view word = first_word(child);
        const DialectWord* entry = find_dialect_word(word, place);
        if (entry != nullptr && entry->modern == wanted) return true;
        if (!nearest_name(word, candidates).empty()) return true;
    }
    return false;
}

source::Diagnostic& CheckContext::report(const source::DiagnosticCode& code, source::Span span,
                                         std::string message) {
    source::Diagnostic diagnostic{&code, code.severity, std::move(message), span, {}, {}, {}};
    std::size_t& count = counts_[static_cast<std::size_t>(code.severity)];
    if (++count > kMostFindings) {
        spare_ = std::move(diagnostic);
        return spare_;
    }
    return found.emplace_back(std::move(diagnostic));
}

}  // namespace cobble::frontend
