// SPDX-License-Identifier: MIT
// The concrete syntax tree. Input: tokens. Output: flat nodes in preorder; every token belongs to
// exactly one node, so that the tree and the tokens rebuild the file byte for byte.
// Invariant: parsing never fails; what is wrong is a node of an error kind or a flag.
#pragma once

#include <cstdint>
#include <vector>

#include "frontend/lex/tokens.hpp"

namespace cobble::frontend {

enum class NodeKind : std::uint8_t {
    kFile,        ///< the root; its tokens end with kEndOfFile
    kBlock,       ///< name [label] { members }; a missing { or } is flagged
    kField,       ///< name values, also inline blocks such as `Translate 1 0 0`
    kNumbers,     ///< the bare numbers of a positional block
    kStrayValue,  ///< values where no field can take them
    kStrayClose,  ///< a } that closes nothing
    kNameless,    ///< { members } without a name, or a single { right after another
    kUnknown,     ///< a word that is no name here, with the values after it
};

struct NodeId {
    std::uint32_t value = 0xffffffffU;
    [[nodiscard]] constexpr bool valid() const { return value != 0xffffffffU; }
    friend constexpr auto operator<=>(NodeId, NodeId) = default;
};

/// Sixteen bytes a node. Its descendants are the nodes (id, end_node).
struct CstNode {
    std::uint32_t kind : 8;        ///< NodeKind
    std::uint32_t has_error : 1;   ///< something in this very node is wrong
    std::uint32_t unclosed : 1;    ///< kBlock or kNameless without its }
    std::uint32_t word_label : 1;  ///< kBlock whose label is a word of the language
    std::uint32_t unused : 21;
    std::uint32_t first_token;
    std::uint32_t end_token;  ///< exclusive
    std::uint32_t end_node;   ///< exclusive
};
static_assert(sizeof(CstNode) == 16);

struct Cst {
    std::vector<CstNode> nodes;  ///< nodes[0] is the file

    [[nodiscard]] const CstNode& node(NodeId id) const { return nodes[id.value]; }
    [[nodiscard]] NodeKind kind(NodeId id) const {
        return static_cast<NodeKind>(nodes[id.value].kind);
    }
    /// The first child, or an invalid id.
    [[nodiscard]] NodeId first_child(NodeId id) const {
        return id.value + 1 < node(id).end_node ? NodeId{id.value + 1} : NodeId{};
    }
    /// The next child of `parent` after `child`, or an invalid id.
    [[nodiscard]] NodeId next_child(NodeId parent, NodeId child) const {
        const std::uint32_t next = node(child).end_node;
        return next < node(parent).end_node ? NodeId{next} : NodeId{};
    }
};

/// The { of a block, or an invalid id if it is missing (`Sphere center 0 0 0 }`, or `Sphere` alone,
/// which has no members either).
TokenId open_brace_of(const Tokens& tokens, const CstNode& block);

/// The label of a block as it stands in the file, well formed and on the name's line or not, or an
/// invalid id.
TokenId label_of(const Tokens& tokens, const CstNode& block);

/// Builds the tree. Cost: one pass over the tokens, any depth of nesting, no recursion.
Cst parse(const Tokens& tokens);

}  // namespace cobble::frontend
