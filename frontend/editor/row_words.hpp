// SPDX-License-Identifier: MIT
// Rows of the vocabulary in words and as samples: what an editor shows about a block or field, and
// what it writes for one. Everything follows from the row; a new field needs nothing here, unless
// no value of its type alone would do (see `sample_value`).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grammar/vocabulary.hpp"

namespace cobble::frontend::editor {

/// What is written after the name: "number", "3 numbers", "colour".
std::string_view type_words(grammar::ValueType type);

/// "above 0", "from 0 to 180, both excluded"; empty if any number will do.
std::string range_words(const grammar::Range& range);

/// "number, degrees, above 0, required": one line about the values of a field.
std::string value_words(const grammar::FieldRow& field);

/// "Stands in `Group` or `Transform`."
std::string parents_words(grammar::BlockId block);

/// "Holds `Noise`."; empty if no block may stand in it.
std::string members_words(grammar::BlockId block);

/// The names of the values in order: "x", "y", "z" or "r", "g", "b" or "c0r0", ...
std::vector<std::string_view> components(const grammar::FieldRow& field);

/// True for three numbers whose direction counts: of a camera, a light, a normal or an axis.
bool is_direction(grammar::FieldId field);

/// Values that are right for a field: its default, or else one that its type and range allow.
std::string sample_value(const grammar::FieldRow& field);

/// A piece of scene text, plain or as a snippet of the Language Server Protocol, in which values
/// are tab stops (`${1:0 0 0}`). Lines after the first are indented as if the first were not.
struct SampleText {
    std::string plain;
    std::string snippet;
};

/// "radius 1"; without its name for an inline or positional block.
SampleText sample_field(const grammar::FieldRow& field);

/// A whole block with what it cannot do without; `label` may be empty.
SampleText sample_block(grammar::BlockId block, std::string_view label = {});

/// The block as an example: what `sample_block` writes, with blocks in those lists that mean
/// nothing when they are empty.
std::string example_block(grammar::BlockId block);

}  // namespace cobble::frontend::editor
