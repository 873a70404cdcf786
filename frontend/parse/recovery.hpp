// SPDX-License-Identifier: MIT
// Which of several blocks lacks its }, or has one too many.
//
// When a block turns out not to be closed, a block inside it may be the culprit: its } is missing,
// and each } after that closed one block too few. When a } is left over, one before it may have
// been too many. The braces do not say which; indentation does.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "frontend/lex/tokens.hpp"
#include "frontend/parse/cst.hpp"
#include "grammar/vocabulary.hpp"

namespace cobble::frontend {

struct Culprit {
    std::uint32_t token;       ///< the token before which a } is missing, or the } too many
    std::uint32_t node_count;  ///< how many nodes begin before it
    /// The blocks open there, from the root of the search to the culprit.
    std::vector<std::uint32_t> open_blocks;
};

/// Looks through the tree from the block `root` to its end for the first place whose indentation
/// says that the block around it should have ended: a } that stands like the opener of a block
/// further out, a member that stands like the opener of its own block and may stand beside it, or a
/// second object in a Transform. `around` is the block around `root` (null if unknown; `at_top` if
/// it is the file). Blocks nested more than 4096 deep are not looked through. Cost: the number of
/// nodes looked at, times at most 64 levels of blocks.
std::optional<Culprit> find_missing_close(const Tokens& tokens, const Cst& cst, std::uint32_t root,
                                          const grammar::BlockRow* around, bool at_top);

/// Looks through the closed block `root` for the first } that stands deeper than the opener of what
/// it closes. Cost: the number of nodes looked at.
std::optional<Culprit> find_extra_close(const Tokens& tokens, const Cst& cst, std::uint32_t root);

}  // namespace cobble::frontend
