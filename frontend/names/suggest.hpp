// SPDX-License-Identifier: MIT
// Did you mean? Names near to a misspelt word.
//
// Two words are near if they differ only in case or in `_` and `-` (`obj_file`, `objFile`), or by
// few edits in lower case: insertions, deletions, replacements and swaps of neighbouring bytes (the
// "optimal string alignment" distance), at most one for every three bytes of the shorter word, one
// at least and three at most. A word shorter than three bytes is near only to its other spellings
// in case.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace cobble::frontend {

/// The edits that lead from one word to the other; `limit + 1` if more than `limit` are needed.
/// `limit` is at most 3. Cost: limit times the length; words past 64 bytes are never near.
std::size_t edit_distance(std::string_view from, std::string_view to, std::size_t limit);

/// The candidates near to `word`, nearest first, in the order of `candidates` where equally near;
/// at most `limit` of them, each once. The word itself is no answer. Deterministic.
std::vector<std::string_view> near_names(std::string_view word,
                                         std::span<const std::string_view> candidates,
                                         std::size_t limit = 3);

/// The nearest candidate, or an empty view.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace cobble::frontend
