// SPDX-License-Identifier: MIT
// The difference of two texts as edits of whole lines: what an editor applies so that folds, cursor
// and breakpoints elsewhere stay.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/lex/tokens.hpp"

namespace cobble::frontend {

/// Some neighbouring lines of the old text and what takes their place. Lines are 0-based here; a
/// line includes its line end (LF, CRLF or lone CR).
struct LineEdit {
    std::uint32_t old_line = 0;   ///< the first line replaced, or before which lines are inserted
    std::uint32_t old_count = 0;  ///< 0: a pure insertion
    std::uint32_t new_line = 0;
    std::uint32_t new_count = 0;  ///< 0: a pure deletion
    ByteRange old_bytes;          ///< of the old text
    ByteRange new_bytes;          ///< of the new text
};

/// The edits that turn `before` into `after`, in order, with at least one equal line between two.
///
/// Made for texts that differ in white space only, where a line can only match one that holds the
/// same characters of the text, so that one walk along both finds the match. Two texts that differ
/// in more give one edit between their common first and last lines. Cost: linear.
std::vector<LineEdit> line_edits(std::string_view before, std::string_view after);

/// `before` with the edits applied, whose `new_bytes` are of `after`.
std::string apply(std::string_view before, std::string_view after,
                  const std::vector<LineEdit>& edits);

}  // namespace cobble::frontend
