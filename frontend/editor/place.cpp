// SPDX-License-Identifier: MIT
#include "frontend/editor/place.hpp"

#include <algorithm>

namespace cobble::frontend::editor {
namespace {

/// The first token of a block behind which its members stand.
std::uint32_t head_end(const CheckedScene& scene, NodeId id) {
    const CstNode& node = scene.cst.node(id);
    const TokenId brace = open_brace_of(scene.tokens, node);
    if (brace.valid()) return brace.value;
    const TokenId label = label_of(scene.tokens, node);
    return label.valid() ? label.value : node.first_token;
}

/// True if the gap before the token `next` is between the braces of a block.
bool is_inside(const CheckedScene& scene, NodeId id, std::uint32_t next) {
    const NodeKind kind = scene.cst.kind(id);
    if (kind != NodeKind::kBlock && kind != NodeKind::kNameless) return false;
    const CstNode& node = scene.cst.node(id);
    const bool members = open_brace_of(scene.tokens, node).valid() || node.end_node > id.value + 1;
    if (!members || next <= head_end(scene, id)) return false;
    return node.unclosed != 0 ? next <= node.end_token : next < node.end_token;
}

}  // namespace

TokenId token_from(const CheckedScene& scene, std::uint32_t offset) {
    const auto& tokens = scene.tokens.tokens;
    const auto found = std::ranges::lower_bound(tokens, offset, {}, &Token::begin);
    const auto index = static_cast<std::uint32_t>(found - tokens.begin());
    return {std::min(index, scene.tokens.size() - 1)};
}

TokenId token_at(const CheckedScene& scene, std::uint32_t offset) {
    const auto& tokens = scene.tokens.tokens;
    const auto found = std::ranges::upper_bound(tokens, offset, {}, &Token::begin);
    // Two candidates: the last token that begins at the offset or before it, and the one before
    // that if the offset is where it ends. The end of the file is no token to speak of.
    auto index = static_cast<std::uint32_t>(found - tokens.begin());
    for (int tries = 0; tries < 2 && index > 0; ++tries) {
        const TokenId token{--index};
        if (scene.tokens.kind(token) == TokenKind::kEndOfFile) continue;
        if (offset <= scene.tokens.range(token).end) return token;
    }
    return {};
}

bool in_comment(const CheckedScene& scene, std::uint32_t offset) {
    const auto& comments = scene.tokens.comments;
    const auto found = std::ranges::lower_bound(comments, offset, {}, &ByteRange::begin);
    return found != comments.begin() && offset <= (found - 1)->end;
}

ByteRange bytes_of(const CheckedScene& scene, NodeId node) {
    const CstNode& record = scene.cst.node(node);
    if (scene.cst.kind(node) == NodeKind::kFile) {
        return {0, static_cast<std::uint32_t>(scene.tokens.text.size())};
    }
    return {scene.tokens.range({record.first_token}).begin,
            scene.tokens.range({record.end_token - 1}).end};
}

std::vector<NodeId> path_to(const CheckedScene& scene, TokenId token) {
    std::vector<NodeId> path = {NodeId{0}};
    const Cst& cst = scene.cst;
    NodeId child = cst.first_child(path.back());
    while (child.valid()) {
        const CstNode& node = cst.node(child);
        if (node.first_token > token.value) break;
        if (token.value < node.end_token) {
            path.push_back(child);
            child = cst.first_child(child);
        } else {
            child = cst.next_child(path.back(), child);
        }
    }
    return path;
}

Gap gap_before(const CheckedScene& scene, TokenId next) {
    const Cst& cst = scene.cst;
    Gap gap{NodeId{0}, {}};
    NodeId child = cst.first_child(gap.around);
    while (child.valid() && cst.node(child).first_token < next.value) {
        if (is_inside(scene, child, next.value)) {
            gap = {child, {}};
            child = cst.first_child(child);
        } else {
            gap.before = child;
            child = cst.next_child(gap.around, child);
        }
    }
    return gap;
}

BlockNodeId block_of(const CheckedScene& scene, NodeId node) {
    const auto& blocks = scene.ast.blocks;
    const auto found = std::ranges::lower_bound(blocks, node, {}, &BlockNode::cst);
    if (found == blocks.end() || found->cst != node) return {};
    return {static_cast<std::uint32_t>(found - blocks.begin())};
}

Place place_at(const CheckedScene& scene, std::uint32_t offset) {
    Place place;
    place.token = token_at(scene, offset);
    if (!place.token.valid()) return place;
    const std::vector<NodeId> path = path_to(scene, place.token);
    // Innermost first: a field stands directly in its block, and an inline block is its own field.
    for (auto node = path.rbegin(); node != path.rend() && !place.block.valid(); ++node) {
        place.block = block_of(scene, *node);
        // What stands in a block that nobody knows belongs to no block around it.
        const NodeKind kind = scene.cst.kind(*node);
        if (kind == NodeKind::kNameless || kind == NodeKind::kBlock) break;
    }
    if (!place.block.valid()) return place;

    const BlockNode& block = scene.ast.block(place.block);
    const bool is_name = scene.cst.node(block.cst).first_token == place.token.value;
    place.is_block_name = is_name;
    place.is_label = block.label == place.token;
    for (const FieldNode& field : scene.ast.fields_of(place.block)) {
        const CstNode& node = scene.cst.node(field.cst);
        if (place.token.value < node.first_token || place.token.value >= node.end_token) continue;
        // The one field of a positional block without numbers is bound to the block itself.
        const bool bare = scene.cst.kind(field.cst) == NodeKind::kBlock;
        if (is_name || bare) continue;
        place.field = &field;
        place.is_field_name =
            scene.cst.kind(field.cst) == NodeKind::kField && node.first_token == place.token.value;
        break;
    }
    return place;
}

ByteRange values_range(const CheckedScene& scene, const FieldNode& field) {
    const CstNode& node = scene.cst.node(field.cst);
    const bool named = scene.cst.kind(field.cst) != NodeKind::kNumbers;
    const std::uint32_t first = node.first_token + (named ? 1 : 0);
    const std::uint32_t behind = scene.tokens.range({node.first_token}).end;
    if (first >= node.end_token || scene.cst.kind(field.cst) == NodeKind::kBlock) {
        return {behind, behind};
    }
    return {scene.tokens.range({first}).begin, scene.tokens.range({node.end_token - 1}).end};
}

std::uint32_t values_in(const CheckedScene& scene, TokenId token) {
    return scene.tokens.kind(token) == TokenKind::kColor ? 3 : 1;
}

}  // namespace cobble::frontend::editor
