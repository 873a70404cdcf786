// SPDX-License-Identifier: MIT
// Findings about the text itself, before any meaning.
#pragma once

#include "frontend/ast/reporter.hpp"

namespace cobble::frontend {

/// Unterminated strings, and bytes that are no UTF-8 (one finding for bytes that stand together).
void report_text_errors(Reporter& reporter);

/// Reports the first character of a token that nobody can see, with a change for all of them;
/// false if it has none.
bool report_invisible(TokenId token, Reporter& reporter);

}  // namespace cobble::frontend
