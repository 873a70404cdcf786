// SPDX-License-Identifier: MIT
// Numbers, and three of them, for the checks that measure.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "frontend/check/context.hpp"
#include "frontend/check/single.hpp"

namespace cobble::frontend {

using Numbers3 = std::array<double, 3>;

/// True if the number is zero in single precision: at most half of its smallest number, 2^-149.
inline bool is_zero(double number) { return std::fabs(number) <= 0x1p-150; }

/// The first three numbers of a field, or nothing if it is absent, broken or too large to be
/// stored (which is said elsewhere), so that squares of squares stay finite.
std::optional<Numbers3> three_numbers(const CheckContext& context, const FieldNode* field);

inline bool is_zero(const Numbers3& v) { return is_zero(v[0]) && is_zero(v[1]) && is_zero(v[2]); }

inline double dot(const Numbers3& a, const Numbers3& b) {
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}
inline Numbers3 minus(const Numbers3& a, const Numbers3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Numbers3 cross(const Numbers3& a, const Numbers3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Numbers3& v) { return std::sqrt(dot(v, v)); }

/// True if two axes are opposite within the rounding of the numbers as written (a few units in the
/// last place of 53 bits): an axis that is interpolated from one to the other meets zero then. The
/// one rule for what is reported and for what lowering leaves out.
inline bool are_opposite(const Numbers3& a, const Numbers3& b) {
    return dot(a, b) < 0 && length(cross(a, b)) <= 0x1p-50 * (length(a) * length(b));
}

}  // namespace cobble::frontend
