// SPDX-License-Identifier: MIT
// What the formatter must prove of its result. Input: the tokens and trees of two texts. Output:
// the first difference that white space alone does not explain, in words, or nothing.
#pragma once

#include <string>

#include "frontend/lex/tokens.hpp"
#include "frontend/parse/cst.hpp"

namespace cobble::frontend {

/// Empty if both texts have the same tokens, byte for byte and kind for kind, and the same comments
/// (blanks at their ends aside), each between the same two tokens and, as before, on the line of
/// the token before it or on a line of its own. Cost: one pass.
std::string token_difference(const Tokens& before, const Tokens& after);

/// Empty if both trees are equal: the same nodes over the same tokens with the same flags.
std::string tree_difference(const Cst& before, const Cst& after);

}  // namespace cobble::frontend
