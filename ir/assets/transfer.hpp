// SPDX-License-Identifier: MIT
// Pictures from display values to light, for `--transfer srgb`.
#pragma once

#include "ir/scene/assets.hpp"

namespace cobble::ir {

/// Turns bytes into floats and tags the picture linear. Pictures that hold light already, or data,
/// stay as they are.
void decode_to_linear(Image& image);

}  // namespace cobble::ir
