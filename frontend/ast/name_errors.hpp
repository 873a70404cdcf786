// SPDX-License-Identifier: MIT
// Findings about names: unknown ones, and known ones where they may not stand.
#pragma once

#include <span>

#include "frontend/ast/reporter.hpp"
#include "frontend/parse/cst.hpp"
#include "grammar/vocabulary.hpp"

namespace cobble::frontend {

/// A name that means nothing where it stands: `around` is the block it stands in (null for the
/// file), `present` the fields that this block has.
void report_unknown_name(const CstNode& node, const grammar::BlockRow* around,
                         std::span<const grammar::FieldId> present, Reporter& reporter);

/// A block of the vocabulary in a block where it may not stand (null for the file). True if its
/// name is evidently a slip for one that may, `Material` for `Materials`: then its members are not
/// to be judged by the name that it has.
bool report_misplaced(const Cst& cst, NodeId block, const grammar::BlockRow& row,
                      const grammar::BlockRow* around, Reporter& reporter);

/// `Translate { 1 0 0 }`: braces where only values may stand.
void report_inline_braces(const CstNode& node, Reporter& reporter);

/// Reports a label that is a word of the language; false if it is none.
bool report_word_as_label(TokenId label, Reporter& reporter);

/// True if the block may have this label and it is well formed. Reports what is wrong with it.
bool accept_label(const grammar::BlockRow& row, TokenId label, Reporter& reporter);

}  // namespace cobble::frontend
