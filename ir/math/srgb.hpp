// SPDX-License-Identifier: MIT
// The transfer function of sRGB (IEC 61966-2-1), the one that 8-bit pictures are meant for.
#pragma once

#include "ir/math/vec.hpp"

namespace cobble::math {

/// From a display value to light, one channel. Values above 1 (bright lights) continue the curve;
/// negative ones are mirrored.
double srgb_to_linear(double display);
Vec3d srgb_to_linear(Vec3d display);

/// The way back, one channel, on the same terms.
double linear_to_srgb(double light);

}  // namespace cobble::math
