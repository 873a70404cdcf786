// SPDX-License-Identifier: MIT
// Materials and what refers to them: definition, references and renaming. Other labels (of lights,
// objects, groups) have no references, but can be renamed too.
//
// Input: a checked scene, its text and a byte offset on the name or label of a material's block, or
// on the value of a MaterialIndex, be it a label or a number. Output: byte ranges; nothing where
// nothing is meant. Cost: one pass over the blocks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"

namespace cobble::frontend::editor {

struct Definition {
    ByteRange origin;     ///< what stands at the offset: the value or the label
    ByteRange span;       ///< the material's block
    ByteRange name_span;  ///< its label, or else its name
};

std::optional<Definition> definition(const CheckedScene& scene, std::string_view text,
                                     std::uint32_t offset);

struct Reference {
    ByteRange span;
    bool is_definition;
};

/// The definition first, then the values of every MaterialIndex that means it, in order.
std::vector<Reference> references(const CheckedScene& scene, std::string_view text,
                                  std::uint32_t offset);

/// What can be renamed at an offset, or why nothing can.
struct RenameTarget {
    ByteRange span;       ///< what stands at the offset
    std::string current;  ///< the label, or the number of a material without one
    std::string refusal;  ///< empty if it can be renamed
};

RenameTarget rename_target(const CheckedScene& scene, std::string_view text, std::uint32_t offset);

struct TextEdit {
    ByteRange span;
    std::string text;
};

struct Rename {
    std::vector<TextEdit> edits;  ///< in order, none overlapping
    std::string refusal;          ///< one sentence; if it is not empty there are no edits
};

/// Gives what is at `offset` the label `name`. A label changes in its block and in every
/// MaterialIndex that writes it; numbers stay numbers. A material without a label gets one, and the
/// MaterialIndex that mean it by number then write it.
Rename rename(const CheckedScene& scene, std::string_view text, std::uint32_t offset,
              std::string_view name);

}  // namespace cobble::frontend::editor
