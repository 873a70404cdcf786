// SPDX-License-Identifier: MIT
// What stands at an offset, explained: a block, a field, a number, a colour, a direction, a
// material, a light.
//
// Input: a checked scene, its text and a byte offset. Output: what to show and for which bytes;
// nothing for white space, comments, braces and words that mean nothing where they stand. What a
// word means comes from the vocabulary; what a value says, from the file. A broken field's values
// are not read. Cost: a look at every sibling along the path to the offset; one pass over the
// materials for a MaterialIndex.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"

namespace cobble::frontend::editor {

struct Hover {
    ByteRange span;
    std::string title;                    ///< one line, Markdown
    std::vector<std::string> paragraphs;  ///< Markdown; one may be a list or a block of code
};

std::optional<Hover> hover(const CheckedScene& scene, std::string_view text, std::uint32_t offset);

/// What completion shows too: the paragraphs about a row of the vocabulary.
std::vector<std::string> block_paragraphs(const grammar::BlockRow& row);
std::vector<std::string> field_paragraphs(const grammar::FieldRow& row);

}  // namespace cobble::frontend::editor
