// SPDX-License-Identifier: MIT
// Which effects a scene calls for, with the place of each cause or the reason it is off.
#pragma once

#include "ir/scene/effects.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// One pass over the scene. Folding is real: an aperture of 0 is no lens, a closed shutter no
/// motion, a mirror that no object is made of no reflection, a one-colour texture no texture.
Effects derive_effects(const Scene& scene);

}  // namespace cobble::ir
