// SPDX-License-Identifier: MIT
// What each word, number and comment of a file is, for colouring it by meaning.
//
// Input: a checked scene and its text. Output: tokens in order, none empty, none overlapping, each
// within a line. Words that mean nothing where they stand are left out, and so are braces. Cost:
// one pass over the tree and one over the tokens.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"

namespace cobble::frontend::editor {

enum class SemanticType : std::uint8_t {
    kSection,
    kCamera,
    kLight,
    kMaterial,   ///< PhongMaterial, Noise, and MaterialIndex
    kObject,     ///< Sphere, ..., and Group
    kTransform,  ///< Transform, Motion, and what stands in them
    kField,
    kNumber,
    kColor,  ///< #rrggbb
    kPath,
    kLabel,
    kComment,
    kKeyword,  ///< a value that is a word of the language
};

/// "section", "camera", ...: the names under which a client knows the types, in their order.
inline constexpr std::string_view kSemanticTypeNames[] = {
    "section", "camera", "light", "material", "object",  "transform", "field",
    "number",  "color",  "path",  "label",    "comment", "keyword"};

struct SemanticToken {
    std::uint32_t begin;
    std::uint32_t length;
    SemanticType type;
    /// The block whose name, field or value it is; kCount_ outside of any known one.
    grammar::BlockId block;
};

std::vector<SemanticToken> semantic_tokens(const CheckedScene& scene, std::string_view text);

}  // namespace cobble::frontend::editor
