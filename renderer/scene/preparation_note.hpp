// SPDX-License-Identifier: MIT
// What narrowing a scene, or a shape itself, cost.
#pragma once

#include <cstdint>

#include "ir/scene/ids.hpp"

namespace cobble::renderer {

/// Something that narrowing or the shape itself cost; never an error: the rest renders.
struct PreparationNote {
    enum class Kind : std::uint8_t {
        kDegenerate,      ///< no area or volume as it is written: never hit
        kFlattened,       ///< none left once narrowed to T: never hit
        kOutOfRange,      ///< beyond what T can hold: never hit
        kIllConditioned,  ///< an instance whose matrix loses most digits of T
        kSingular,        ///< an instance without an inverse: never hit
    };
    Kind kind = Kind::kDegenerate;
    ir::ObjectId object;
    std::uint32_t face = 0;   ///< the first one, of a mesh
    std::uint32_t count = 1;  ///< how many faces of the object
};

}  // namespace cobble::renderer
