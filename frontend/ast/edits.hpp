// SPDX-License-Identifier: MIT
// Ranges of text for fixes.
#pragma once

#include "frontend/lex/tokens.hpp"

namespace cobble::frontend {

/// What to delete so that the tokens from `first` to `last` leave no trace: their lines where
/// nothing else stands on them, else themselves and the blanks before them.
ByteRange removal_range(const Tokens& tokens, TokenId first, TokenId last);

}  // namespace cobble::frontend
