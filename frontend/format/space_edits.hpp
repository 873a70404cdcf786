// SPDX-License-Identifier: MIT
// From a text to its formatted one by edits of white space: what an editor applies, so that folds,
// marks and the cursor stay where they are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cobble::frontend {

/// Replace the bytes [begin, end) of the text before.
struct SpaceEdit {
    std::uint32_t begin = 0, end = 0;
    std::string text;
};

/// The runs of blanks and line ends that differ, in order. `after` differs from `before` in those
/// alone, as format() proves of its results; if it does not, the one edit is the whole text.
/// Cost: one pass.
std::vector<SpaceEdit> space_edits(std::string_view before, std::string_view after);

}  // namespace cobble::frontend
