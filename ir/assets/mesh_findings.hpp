// SPDX-License-Identifier: MIT
// Findings about a mesh that depend on what it is used for.
#pragma once

#include <string_view>

#include "ir/assets/asset_loader.hpp"

namespace cobble::ir {

/// Warns if faces of a mesh under a normal or bump map have texture coordinates (or none at all)
/// from which no tangent follows. `text` is the mesh file's, `span` its path in the scene.
void report_degenerate_uvs(AssetLoader& loader, const LoadedObj& loaded, std::string_view text,
                           source::Span span);

}  // namespace cobble::ir
