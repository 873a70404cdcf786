// SPDX-License-Identifier: MIT
// What the cursor is about to write: the word that it touches, the block around it, and the field
// that still takes values there.
//
// Input: a checked scene and the byte offset of the cursor. Works on the tokens and the CST, so
// that it holds where the AST has given up. Cost: the siblings along the path to the offset.
#pragma once

#include <cstdint>

#include "frontend/check/check.hpp"
#include "frontend/editor/place.hpp"

namespace cobble::frontend::editor {

struct Typing {
    bool nothing = false;  ///< in a comment, at a label, or where nobody knows what may stand
    TokenId word;          ///< begins before the cursor and reaches it; invalid: none
    ByteRange span;        ///< of `word`, or empty at the cursor
    NodeId around;         ///< the block whose members are written here, or the file
    const grammar::BlockRow* block = nullptr;  ///< of `around`; null at the top level

    /// The field that the cursor is behind, if it takes values; null: none.
    const grammar::FieldRow* field = nullptr;
    std::uint32_t values_before = 0;  ///< of it, before the cursor's word
    std::uint32_t values_behind = 0;  ///< of it, behind the cursor's word
    bool on_field_line = false;       ///< on the line of what stands before

    /// Whether the field has room for a value here.
    [[nodiscard]] bool wants_value() const;
    /// Whether a new member may begin here.
    [[nodiscard]] bool takes_member() const;
};

Typing typing_at(const CheckedScene& scene, std::uint32_t offset);

}  // namespace cobble::frontend::editor
