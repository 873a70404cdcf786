// SPDX-License-Identifier: MIT
// The inverse of an affine map, careful enough that it can be relied on.
#pragma once

#include <optional>

#include "ir/math/affine.hpp"

namespace cobble::math {

struct Inverse {
    Affined map;
    bool mirrors = false;  ///< the determinant is negative
    double condition = 1;  ///< see condition()
};

/// Nothing if the map is singular, or if it or its inverse leaves the range of doubles. Cofactors
/// and determinant in double-double, on a matrix whose rows and columns were scaled by powers of
/// two, so that each entry is nearly correctly rounded: |inverse * map - identity| is at most 64 u
/// times the condition, u = 2^-53.
std::optional<Inverse> invert(const Affined& map);

/// The map of invert() alone.
std::optional<Affined> inverse(const Affined& map);

/// |A^-1| |A| of the linear part, in the norm of the largest row sum: about how many times a
/// rounding in the one space is larger in the other. At least 1.
double condition(const Affined& map, const Affined& inverse_map);

}  // namespace cobble::math
