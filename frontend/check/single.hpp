// SPDX-License-Identifier: MIT
// What single precision can hold.
#pragma once

#include <cmath>
#include <limits>

namespace cobble::frontend {

/// The renderer narrows numbers once to single precision, and published programs read them so: a
/// magnitude beyond this has no place there.
inline constexpr double kLargestNumber = std::numeric_limits<float>::max();

/// False for what is not finite, too.
inline bool fits_single(double number) { return std::fabs(number) <= kLargestNumber; }

}  // namespace cobble::frontend
