// SPDX-License-Identifier: MIT
// What float leaves of a double.
#pragma once

#include <cmath>
#include <limits>

namespace cobble::math {

/// Coordinates beyond these are not reckoned with: products of three leave the range of the type
/// that T is tested in, 2^-1022 to 2^1023 for both (with room for the parts of a double-double
/// product).
template <typename T>
inline constexpr T kLargestCoordinate = T(0x1p120);
template <>
inline constexpr double kLargestCoordinate<double> = 0x1p300;

/// From the number of type T nearest to |x| to the next larger one; infinite beyond its range.
template <typename T>
T step_at(double x) {
    const T size = std::fabs(static_cast<T>(x));
    return std::nextafter(size, std::numeric_limits<T>::infinity()) - size;
}

}  // namespace cobble::math
