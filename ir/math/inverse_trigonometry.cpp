// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "ir/math/elementary.hpp"
#include "ir/math/kernels.hpp"

namespace cobble::math {

namespace {

/// The angle of (x, y) for x > 0, 0 < y <= x, the larger near 1, y / x > 2^-60. A crude angle a,
/// then what is missing: atan((y cos a - x sin a) / (x cos a + y sin a)).
DoubleDouble first_octant(DoubleDouble y, DoubleDouble x) {
    const double t = y.hi / x.hi;
    const double w = t * t;
    // Chebyshev fit of atan(t) / t in t^2 on [0, 1]: relative error 5e-6.
    const double a =
        t *
        (0.9999948 +
         w * (-0.3329571 + w * (0.1953466 + w * (-0.1204486 + w * (0.05658999 - 0.01313038 * w)))));
    const detail::SinCosDd rotation = detail::sincos_kernel(DoubleDouble(a));
    const DoubleDouble sine = y * rotation.cos - x * rotation.sin;
    const double cosine = x.hi * rotation.cos.hi + y.hi * rotation.sin.hi;
    const double missing = sine.hi / cosine;
    // |missing| < 1e-5: the next term of the series is 1e-25.
    return quick_two_sum(a, missing - missing * missing * missing / 3);
}

/// The angle of (x, y) in [0, pi / 2] for finite x, y >= 0, not both 0.
DoubleDouble first_quadrant(DoubleDouble y, DoubleDouble x) {
    const bool steep = y.hi > x.hi;
    const DoubleDouble longer = steep ? y : x;
    const DoubleDouble shorter = steep ? x : y;
    DoubleDouble angle;
    const int e = detail::exponent(longer.hi);
    if (shorter.hi != 0) {
        const int gap = e - detail::exponent(shorter.hi);
        if (gap > 60) {
            // atan t = t to 120 bits; one rounding.
            angle = DoubleDouble(shorter.hi / longer.hi);
        } else {
            const DoubleDouble s(detail::scale(shorter.hi, -e), detail::scale(shorter.lo, -e));
            const DoubleDouble l(detail::scale(longer.hi, -e), detail::scale(longer.lo, -e));
            angle = first_octant(s, l);
        }
    }
    return steep ? detail::kHalfPiDd - angle : angle;
}

}  // namespace

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
    double ax = std::fabs(x);
    double ay = std::fabs(y);
    if (std::isinf(ax) || std::isinf(ay)) {
        // Only the ratio's limit counts.
        ax = std::isinf(ax) ? 1 : 0;
        ay = std::isinf(ay) ? 1 : 0;
    }
    DoubleDouble angle;
    if (ax != 0 || ay != 0) angle = first_quadrant(DoubleDouble(ay), DoubleDouble(ax));
    if (std::signbit(x)) angle = detail::kPiDd - angle;
    return std::copysign(angle.hi, y);
}

double acos(double x) {
    if (!(std::fabs(x) <= 1)) return std::numeric_limits<double>::quiet_NaN();
    // The angle of (x, sqrt(1 - x^2)); the difference is exact up to 2^-104 of itself.
    const DoubleDouble square = std::fabs(x) < 0x1p-100 ? DoubleDouble() : two_product(x, x);
    const DoubleDouble height = sqrt(DoubleDouble(1) - square);
    if (height.hi == 0) return x > 0 ? 0 : kPi;
    const DoubleDouble angle = first_quadrant(height, DoubleDouble(std::fabs(x)));
    return x < 0 ? (detail::kPiDd - angle).hi : angle.hi;
}

}  // namespace cobble::math
