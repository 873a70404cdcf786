// SPDX-License-Identifier: MIT
// What looks like a picture or a pattern but is one colour.
#pragma once

#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// Where every object of a material carries texture coordinates everywhere, a texture of one colour
/// becomes the diffuse colour; a noise between equal colours becomes that colour. The picture stays
/// the same, bit for bit: a blend of equal values is that value. Not in compatibility modes, where
/// ambient light takes the diffuse colour beside the texture.
void fold_constants(Scene& scene);

/// True if every hit on the object has texture coordinates.
bool has_uv_everywhere(const Scene& scene, const Object& object);

/// True if some hit on the object may have texture coordinates.
bool has_uv_somewhere(const Scene& scene, const Object& object);

}  // namespace cobble::ir
