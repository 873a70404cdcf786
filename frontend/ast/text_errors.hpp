// SPDX-License-Identifier: MIT
// Findings about the text itself, before any meaning.
#pragma once

#include "frontend/ast/reporter.hpp"

namespace cobble::frontend {

/// Unterminated strings, and bytes that are no UTF-8 (one finding for bytes that stand together).
void report_text_errors(Reporter& reporter);

}  // namespace cobble::frontend
