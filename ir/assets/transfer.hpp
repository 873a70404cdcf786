// SPDX-License-Identifier: MIT
// From display values to light, for `--transfer srgb` (IEC 61966-2-1).
#pragma once

#include "ir/math/vec.hpp"
#include "ir/scene/assets.hpp"

namespace cobble::ir {

/// One channel. Values above 1 (bright lights) continue the curve; negative ones are mirrored.
double srgb_to_linear(double value);
math::Vec3d srgb_to_linear(math::Vec3d color);

/// Turns bytes into floats and tags the picture linear. Pictures that hold light already, or data,
/// stay as they are.
void decode_to_linear(Image& image);

}  // namespace cobble::ir
