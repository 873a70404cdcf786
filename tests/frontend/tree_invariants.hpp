// SPDX-License-Identifier: MIT
// What must hold for the tokens and the tree of any text at all.
#pragma once

#include <string>
#include <string_view>

#include "frontend/parse/cst.hpp"

namespace cobble::test {

/// The text as tokens, comments and the white space between them rebuild it; other than the text
/// itself if a byte is lost, doubled, or taken for white space that is none.
std::string rebuilt(const frontend::Tokens& tokens);

/// "" if every token belongs to exactly one node, nodes stand in preorder and inside their parents,
/// and braces stand where the nodes say; else what is wrong.
std::string tree_fault(const frontend::Tokens& tokens, const frontend::Cst& cst);

}  // namespace cobble::test
