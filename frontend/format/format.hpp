// SPDX-License-Identifier: MIT
// The formatter. Input: text. Output: text that differs in white space only, which it proves before
// it returns. Invariant: never loses a byte of a token or comment, on valid and invalid files
// alike.
//
// Layout: four spaces a level (up to 20 levels, see layout.hpp); one field a line; `{` on the line
// of its block's name, `}` on its own; an empty block is `Material {}`; `Rotate` stays on one line
// and `Matrix4f` is four lines of four. At most one blank line in a row, none after `{`, before `}`
// and at both ends of the file. Nothing is reordered, and no line is broken for being long.
// A comment stays with the token before it if it is on that token's line, else on a line of its own
// before the token that follows; one between two values of a field leaves the rest on the next
// line, indented once more.
//
// Kept: digits of numbers, a byte-order mark, the bytes from `// cobble-format off` to
// `// cobble-format on` (or to the end of the file), and the innermost block around each syntax
// error (the whole top-level block if it is a missing brace), with its own indentation; broken
// parts that share a line still share it, since line ends can decide what they are taken for. Line
// ends that are written are all like the first in the file (LF, CRLF or lone CR; LF if there is
// none), and the last line has one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cobble::frontend {

struct FormatOptions {
    /// Lines to format, 1-based and inclusive; both 0 for the whole file. The bytes of all other
    /// lines stay as they are.
    std::uint32_t first_line = 0;
    std::uint32_t last_line = 0;
};

struct FormatResult {
    std::string text;         ///< the whole file, formatted; equals the input if `refused`
    bool has_errors = false;  ///< the file has syntax errors: broken blocks were left verbatim
    /// The errors leave open what belongs to what, and another layout would change the answer: the
    /// text equals the input. Only with `has_errors`.
    bool left_alone = false;
    bool refused = false;  ///< the proof failed (an internal error): nothing was changed
    std::string refusal;   ///< why, for a bug report
};

/// Formats a text of less than 4 GiB; a larger one, or result, is refused.
///
/// The proof: lexed again, the result has the same token kinds and bytes and the same comments at
/// the same neighbours; parsed again, it has the same tree; formatted again, it does not change.
/// Cost: linear, two runs of lexer, parser and writer; above 50 MB/s.
FormatResult format(std::string_view text, const FormatOptions& options = {});

}  // namespace cobble::frontend
