// SPDX-License-Identifier: MIT
// Pieces that the elementary functions share; private to ir/math.
#pragma once

#include <bit>
#include <cstdint>

#include "ir/math/double_double.hpp"
#include "ir/math/power_of_two.hpp"

namespace cobble::math::detail {

/// x 2^k for k in [-2200, 2200], in steps that stay in range; rounded only if the result is
/// subnormal.
inline double scale(double x, int k) {
    while (k > 1000) {
        x *= power_of_two(1000);
        k -= 1000;
    }
    while (k < -960) {
        // A last step of at least 2^-1000 would leave a result that was rounded here already.
        x *= power_of_two(-960);
        k += 960;
    }
    return x * power_of_two(k);
}

/// The k with 2^k <= |x| < 2^(k + 1), for finite x other than 0.
inline int exponent(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x) & 0x7fffffffffffffffU;
    if ((bits >> 52) != 0) return static_cast<int>(bits >> 52) - 1023;
    return 63 - std::countl_zero(bits) - 1074;
}

inline constexpr DoubleDouble kPiDd{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr DoubleDouble kHalfPiDd{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// Sine and cosine with a little more than double's precision: absolute errors below 2^-55, that of
/// the sine relative to it.
struct SinCosDd {
    DoubleDouble sin, cos;
};

/// For |x| <= pi / 4 (and a little more). Taylor series: the first terms left out, x^19 / 19! and
/// x^20 / 20!, are below 2^-63 of the results.
SinCosDd sincos_kernel(DoubleDouble x);

/// x = result + quadrant pi / 2, |result| <= pi / 4 (1 + 2^-40), for any finite x.
struct Reduced {
    DoubleDouble rest;
    unsigned quadrant = 0;  ///< modulo 4
};
Reduced reduce_half_pi(double x);

}  // namespace cobble::math::detail
