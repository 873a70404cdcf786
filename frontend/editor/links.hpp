// SPDX-License-Identifier: MIT
// The paths of a file, for opening what they name. Input: a checked scene and its text. Output: in
// order of the file; no file is looked at, so that a path may lead nowhere. Cost: one pass over the
// fields.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"

namespace cobble::frontend::editor {

enum class PathKind : std::uint8_t { kNone, kImage, kMesh, kFolder };

/// What a value of this type names, kNone for what is no path.
PathKind path_kind(grammar::ValueType type);

struct PathLink {
    ByteRange span;         ///< of the path without its quotes
    std::string_view path;  ///< as it stands in the text, relative to the scene file
    PathKind kind;
};

std::vector<PathLink> links(const CheckedScene& scene, std::string_view text);

}  // namespace cobble::frontend::editor
