// SPDX-License-Identifier: MIT
// Where an offset is: which token it touches, and which nodes of the trees hold that token.
//
// Input: a checked scene, half typed or broken as it may be, and byte offsets into its text; an
// offset past the end counts as the end. Nothing is kept between calls and nothing is changed.
// Cost: a binary search for a token; a path costs a look at every sibling along it.
#pragma once

#include <cstdint>
#include <vector>

#include "frontend/check/check.hpp"

namespace cobble::frontend::editor {

/// The token that holds the byte at `offset`, or else the one that ends there; invalid in white
/// space and at the end of the file.
TokenId token_at(const CheckedScene& scene, std::uint32_t offset);

/// The first token that begins at `offset` or behind it: kEndOfFile is one.
TokenId token_from(const CheckedScene& scene, std::uint32_t offset);

/// True if text that is typed at `offset` belongs to a comment.
bool in_comment(const CheckedScene& scene, std::uint32_t offset);

/// The bytes of a node, from its first token to its last. The file's are all of the text.
ByteRange bytes_of(const CheckedScene& scene, NodeId node);

/// The nodes that hold `token`, from the file to the innermost.
std::vector<NodeId> path_to(const CheckedScene& scene, TokenId token);

/// What stands around the gap before a token.
struct Gap {
    NodeId around;  ///< the innermost block whose braces are around it, or the file
    NodeId before;  ///< its last member that begins before the gap, or invalid
};

/// The gap before `next`. Behind the last member of a block without its }, it is still in the
/// block: people type there.
Gap gap_before(const CheckedScene& scene, TokenId next);

/// The block of the AST that is bound to a node, or an invalid id.
BlockNodeId block_of(const CheckedScene& scene, NodeId node);

/// What a token is to the AST.
struct Place {
    TokenId token;
    BlockNodeId block;                 ///< the innermost block that holds it, or invalid
    const FieldNode* field = nullptr;  ///< the field of `block` that holds it, or null
    bool is_block_name = false;
    bool is_label = false;
    bool is_field_name = false;
};

/// Everything about the token at `offset`; all is empty where there is none.
Place place_at(const CheckedScene& scene, std::uint32_t offset);

/// The bytes from a field's first value to its last; empty, behind the name, if there are none.
ByteRange values_range(const CheckedScene& scene, const FieldNode& field);

/// How many values a token stands for: three for a colour written as #rrggbb.
std::uint32_t values_in(const CheckedScene& scene, TokenId token);

}  // namespace cobble::frontend::editor
