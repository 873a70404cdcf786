// SPDX-License-Identifier: MIT
// The scene as JSON, for people and tools; written, never read.
#pragma once

#include <string>

#include "frontend/source/source_map.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// Begins `"cobble_ir": 1`; angles in radians, colours as 3 numbers, transforms as 16 numbers
/// column by column, images and meshes by size and path only.
std::string to_json(const Scene& scene, const source::SourceMap& sources);

}  // namespace cobble::ir
