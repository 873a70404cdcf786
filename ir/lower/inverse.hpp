// SPDX-License-Identifier: MIT
// The inverse of an affine map, careful enough that it can be relied on.
#pragma once

#include <optional>

#include "ir/math/affine.hpp"

namespace cobble::ir {

struct Inverse {
    math::Affined map;
    bool mirrors = false;  ///< the determinant is negative
    /// Norm of the linear part times norm of its inverse (largest row sums): by what factor
    /// relative errors can grow.
    double condition = 1;
};

/// Nothing if the map is singular or if it or its inverse leaves the range of doubles. Cofactors
/// and determinant are taken in twice the working precision (Dekker, "A floating-point technique
/// for extending the available precision", 1971) on a matrix whose rows and columns were scaled by
/// powers of two, so that each entry is nearly correctly rounded: |inverse * map - identity| is at
/// most 64 u times the condition, u = 2^-53.
std::optional<Inverse> invert(const math::Affined& map);

}  // namespace cobble::ir
