// SPDX-License-Identifier: MIT
// Where every token goes. Input: tokens and tree. Output: one record for the gap before each token
// (the last is the end of the file). Invariant: looks at no white space but whether a label stands
// on the line of its name, which formatting does not change, so that a formatted text has the
// layout of its source.
#pragma once

#include <cstdint>
#include <vector>

#include "frontend/lex/tokens.hpp"
#include "frontend/parse/cst.hpp"

namespace cobble::frontend {

/// Levels past this one are indented no further. A million nested blocks would otherwise take a
/// million million spaces; published scenes nest fewer than ten levels, and 80 columns of
/// indentation leave 20 of the customary 100.
inline constexpr std::uint8_t kMaxIndentLevels = 20;

enum class GapKind : std::uint8_t {
    kVerbatim,    ///< keep the bytes: inside a broken block
    kGlue,        ///< nothing, as in `{}`
    kSpace,       ///< one space, or a new line after a comment
    kLine,        ///< a new line
    kOwnIndent,   ///< a new line before broken text, which keeps its own indentation
    kStrayIndent  ///< the same, but in the middle of a line it stays there
};

/// The gap before one token. Levels are already capped.
struct Gap {
    GapKind kind = GapKind::kVerbatim;
    std::uint8_t level = 0;          ///< of the token, if it begins a line
    std::uint8_t comment_level = 0;  ///< of comments on lines of their own in this gap
    bool blank_first : 1 = false;    ///< a blank line may follow what stands before the gap
    bool blank_last : 1 = false;     ///< a blank line may stand right before the token
    bool blank_between : 1 = false;  ///< a blank line may stand between two comments
};
static_assert(sizeof(Gap) == 4);

struct Layout {
    std::vector<Gap> gaps;    ///< one per token
    bool has_errors = false;  ///< something in the tree is wrong
};

/// Cost: two passes over the nodes and one over the tokens; four bytes a token.
Layout lay_out(const Tokens& tokens, const Cst& cst);

}  // namespace cobble::frontend
