// SPDX-License-Identifier: MIT
// The formatter. Input: text. Output: text that differs in white space only, which it proves before
// it returns. Invariant: never loses a byte of a token or comment, on valid and invalid files
// alike.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cobble::frontend {

struct FormatOptions {
    /// Lines to format, 1-based and inclusive; both 0 for the whole file.
    std::uint32_t first_line = 0;
    std::uint32_t last_line = 0;
};

struct FormatResult {
    std::string text;         ///< the whole file, formatted; equals the input if `refused`
    bool has_errors = false;  ///< the file has syntax errors: broken blocks were left verbatim
    bool refused = false;     ///< the proof failed (an internal error): nothing was changed
    std::string refusal;      ///< why, for a bug report
};

/// Cost: two lexer passes and one parse; at least 50 MB/s.
FormatResult format(std::string_view text, const FormatOptions& options = {});

}  // namespace cobble::frontend
