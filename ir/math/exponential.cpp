// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "ir/math/elementary.hpp"
#include "ir/math/kernels.hpp"

namespace cobble::math {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// ln 2 in a part of 42 bits, whose product with an exponent is exact, and the rest.
constexpr double kLn2High = 0x1.62e42fefa38p-1;
constexpr double kLn2Low = 0x1.ef35793c7673p-45;

/// e^x. Relative error below 1 ulp if x.lo is the tail of x.hi.
double exp_dd(DoubleDouble x) {
    // The least double is 2^-1074 = e^-744.4, the greatest e^709.8.
    if (x.hi > 710) return kInfinity;
    if (x.hi < -746) return 0;
    const double k = std::floor(x.hi * 0x1.71547652b82fep+0 + 0.5);
    const DoubleDouble high = two_sum(x.hi - k * kLn2High, -(k * kLn2Low));
    const DoubleDouble r = quick_two_sum(high.hi, high.lo + x.lo);
    const double z = r.hi;
    // |r| < 0.35: the first term left out, r^15 / 15!, is below 2^-62.
    const double tail =
        z * z * z *
        (1.0 / 6 +
         z * (1.0 / 24 +
              z * (1.0 / 120 +
                   z * (1.0 / 720 +
                        z * (1.0 / 5040 +
                             z * (1.0 / 40320 +
                                  z * (1.0 / 362880 +
                                       z * (1.0 / 3628800 +
                                            z * (1.0 / 39916800 +
                                                 z * (1.0 / 479001600 +
                                                      z * (1.0 / 6227020800 +
                                                           z * (1.0 / 87178291200))))))))))));
    const DoubleDouble one_r = quick_two_sum(1, z);
    const double value = one_r.hi + (one_r.lo + (r.lo + r.lo * z + (0.5 * z * z + tail)));
    return detail::scale(value, static_cast<int>(k));
}

/// ln x for finite x > 0, to some 2^-68 of it. With x = 2^k m and s = (m - 1) / (m + 1):
/// ln m = 2 (s + s^3 / 3 + s^5 / 5 ...), |s| < 0.172; the terms from s^7 on need only double.
DoubleDouble log_dd(double x) {
    int k = detail::exponent(x);
    double m = detail::scale(x, -k);
    if (m > 1.4142135623730951) {
        m *= 0.5;
        k += 1;
    }
    const DoubleDouble s = DoubleDouble(m - 1) / two_sum(m, 1);
    const DoubleDouble w = s * s;
    const double z = w.hi;
    // |s|^2 < 0.0295: the first term left out, of 2 s, is z^13 / 27 < 2^-70.
    const double tail =
        1.0 / 7 +
        z * (1.0 / 9 +
             z * (1.0 / 11 +
                  z * (1.0 / 13 +
                       z * (1.0 / 15 +
                            z * (1.0 / 17 +
                                 z * (1.0 / 19 +
                                      z * (1.0 / 21 + z * (1.0 / 23 + z * (1.0 / 25)))))))));
    constexpr DoubleDouble kThird{0x1.5555555555555p-2, 0x1.5555555555555p-56};
    constexpr DoubleDouble kFifth{0x1.999999999999ap-3, -0x1.999999999999ap-57};
    const DoubleDouble series =
        DoubleDouble(1) + w * (kThird + w * (kFifth + w * DoubleDouble(tail)));
    DoubleDouble result = s * series;
    result = {2 * result.hi, 2 * result.lo};
    if (k == 0) return result;
    const double n = k;
    return (DoubleDouble(n * kLn2High) + two_product(n, kLn2Low)) + result;
}

bool is_integer(double y) { return std::floor(y) == y; }
bool is_odd(double y) {
    // From 2^53 on every double is even.
    return std::fabs(y) < 0x1p53 && is_integer(y) && std::floor(y * 0.5) * 2 != y;
}

}  // namespace

double exp(double x) {
    if (std::isnan(x)) return x;
    return exp_dd(DoubleDouble(x));
}

double log(double x) {
    if (std::isnan(x) || x < 0) return kNan;
    if (x == 0) return -kInfinity;
    if (x == kInfinity) return x;
    return log_dd(x).hi;
}

double pow(double x, double y) {
    if (y == 0 || x == 1) return 1;
    if (std::isnan(x) || std::isnan(y)) return kNan;
    const bool odd = is_odd(y);
    const double sign = odd && std::signbit(x) ? -1.0 : 1.0;
    const double base = std::fabs(x);
    if (std::isinf(y)) {
        if (base == 1) return 1;
        return (base > 1) == (y > 0) ? kInfinity : 0;
    }
    if (base == 0 || std::isinf(base))
        return (base == 0) == (y < 0) ? sign * kInfinity : sign * 0.0;
    if (x < 0 && !is_integer(y)) return kNan;
    const DoubleDouble l = log_dd(base);
    // So far out that the result over- or underflows, or is 1 to the last bit: no product needed
    // (and none of what follows can then overflow or underflow in its parts).
    const double estimate = l.hi * y;
    if (estimate > 800) return sign * kInfinity;
    if (estimate < -800) return sign * 0.0;
    if (std::fabs(estimate) < 0x1p-60) return sign;
    return sign * exp_dd(l * DoubleDouble(y));
}

}  // namespace cobble::math
