// SPDX-License-Identifier: MIT
// The abstract syntax tree: blocks and fields of the vocabulary, with typed values.
// Input: tokens and CST. Output: flat arrays, bound to the CST, and the diagnostics of
// everything that could not be bound (unknown names, misplaced blocks, malformed values, braces).
// Invariant: a node or field that is wrong in itself is kept and marked `broken`, so that later
// phases neither trip over it nor complain about what follows from it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frontend/lex/tokens.hpp"
#include "frontend/parse/cst.hpp"
#include "frontend/source/diagnostic.hpp"
#include "grammar/vocabulary.hpp"

namespace cobble::frontend {

struct BlockNodeId {
    std::uint32_t value = 0xffffffffU;
    [[nodiscard]] constexpr bool valid() const { return value != 0xffffffffU; }
    friend constexpr auto operator<=>(BlockNodeId, BlockNodeId) = default;
};

/// One value as it stands in the file. For words and strings `number` is unused.
struct Value {
    double number = 0;  ///< a component of a colour token is component / 255
    TokenId token;      ///< three values of one #rrggbb share their token
};

struct FieldNode {
    grammar::FieldId row;
    bool broken = false;        ///< wrong arity or type, or a malformed number: do not read
    std::uint32_t first_value;  ///< into Ast::values
    std::uint32_t value_count;
    NodeId cst;
};

/// A block, or an inline block such as `Translate 1 0 0` (whose one field is its numbers).
struct BlockNode {
    grammar::BlockId row;
    bool broken = false;  ///< the block itself is unusable: misplaced, or its braces are wrong
    TokenId label;        ///< invalid: none
    std::uint32_t first_child = 0;  ///< into Ast::children
    std::uint32_t child_count = 0;
    std::uint32_t first_field = 0;  ///< into Ast::fields; duplicates are kept, in order
    std::uint32_t field_count = 0;
    BlockNodeId parent;
    NodeId cst;
};

struct Ast {
    source::SourceId source;
    /// In preorder of the file, and so in the order of their CST nodes.
    std::vector<BlockNode> blocks;
    std::vector<BlockNodeId> children;  ///< the children of one block are neighbours
    std::vector<FieldNode> fields;      ///< the fields of one block are neighbours
    std::vector<Value> values;
    std::vector<BlockNodeId> roots;  ///< the top-level blocks in order
    /// True if an error was found that makes "missing", "unused" and count findings unreliable
    /// (a deleted brace, a misplaced section).
    bool structure_broken = false;

    [[nodiscard]] const BlockNode& block(BlockNodeId id) const { return blocks[id.value]; }
    [[nodiscard]] std::span<const BlockNodeId> children_of(BlockNodeId id) const {
        return std::span(children).subspan(block(id).first_child, block(id).child_count);
    }
    [[nodiscard]] std::span<const FieldNode> fields_of(BlockNodeId id) const {
        return std::span(fields).subspan(block(id).first_field, block(id).field_count);
    }
    [[nodiscard]] std::span<const Value> values_of(const FieldNode& field) const {
        return std::span(values).subspan(field.first_value, field.value_count);
    }
    /// The field that counts: the last unbroken one with this row (the last wins), or null.
    [[nodiscard]] const FieldNode* find(BlockNodeId id, grammar::FieldId row) const;
};

struct BoundAst {
    Ast ast;
    std::vector<source::Diagnostic> diagnostics;  ///< in order of their spans
};

/// Cost: one pass over the tree.
BoundAst bind(source::SourceId source, const Tokens& tokens, const Cst& cst);

}  // namespace cobble::frontend
