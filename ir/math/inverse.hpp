// SPDX-License-Identifier: MIT
// Inverse of an affine map.
#pragma once

#include <optional>

#include "ir/math/affine.hpp"

namespace cobble::math {

/// By cofactors in double-double, each entry rounded once: the residual is the rounding's, however
/// the map is conditioned. Nothing if the determinant is zero, or the inverse is not finite.
std::optional<Affined> inverse(const Affined& map);

/// |A^-1| |A| of the linear part, in the norm of the largest row sum: about how many times a
/// rounding in the one space is larger in the other. At least 1.
double condition(const Affined& map, const Affined& inverse_map);

}  // namespace cobble::math
