// SPDX-License-Identifier: MIT
// Elementary functions that have the same bits on every platform.
//
// The C library's versions differ between systems in the last bits; these use only operations that
// IEEE 754 defines (+ - * / sqrt and exact scalings), in one order. Errors are bounds in units in
// the last place of a double, tested against double-double arithmetic: at most 2 ulp; a float
// result is the double's, rounded once (at most 1 ulp). NaN gives NaN.
#pragma once

namespace cobble::math {

inline constexpr double kPi = 3.141592653589793;

/// Radians; any finite argument (large ones are reduced with 1200 bits of 2/pi). Infinite: NaN.
double sin(double x);
double cos(double x);
double tan(double x);
struct SinCos {
    double sin, cos;
};
SinCos sincos(double x);

/// Degrees, exact at multiples of 90 (so that a quarter turn is a permutation), reduced exactly.
SinCos sincos_degrees(double degrees);

/// In [0, pi]; |x| > 1: NaN.
double acos(double x);
/// In [-pi, pi], with the C library's rules for zeros and infinities.
double atan2(double y, double x);

double exp(double x);
/// x > 0; 0: -infinity; negative: NaN.
double log(double x);
/// The C library's rules for special cases; at most 2 ulp elsewhere.
double pow(double x, double y);

}  // namespace cobble::math
