// SPDX-License-Identifier: MIT
// Numbers of twice the precision of double: the unevaluated sum hi + lo.
//
// Products by Dekker's splitting (Numer. Math. 18, 1971), sums by Knuth's two-sum, so that nothing
// depends on a fused multiply-add. Exact as long as no product overflows (factors below 2^996) and
// none of its parts underflows (products above 2^-968, or 0).
#pragma once

#include <cmath>

namespace cobble::math {

struct DoubleDouble {
    double hi = 0, lo = 0;

    constexpr DoubleDouble() = default;
    // A double is the same number here, so the conversion is silent.
    constexpr DoubleDouble(double value) : hi(value) {}
    constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}
    constexpr explicit operator double() const { return hi + lo; }
};

/// a + b exactly.
constexpr DoubleDouble two_sum(double a, double b) {
    const double s = a + b;
    const double bb = s - a;
    return {s, (a - (s - bb)) + (b - bb)};
}

/// a + b exactly, if |a| >= |b| or a is 0.
constexpr DoubleDouble quick_two_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
}

/// a b exactly.
constexpr DoubleDouble two_product(double a, double b) {
    constexpr double kSplitter = 134217729.0;  // 2^27 + 1: halves of 26 bits
    const double ta = kSplitter * a;
    const double ah = ta - (ta - a);
    const double al = a - ah;
    const double tb = kSplitter * b;
    const double bh = tb - (tb - b);
    const double bl = b - bh;
    const double p = a * b;
    return {p, ((ah * bh - p) + ah * bl + al * bh) + al * bl};
}

constexpr DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }

/// Relative error at most 3 * 2^-106 (Joldes, Muller and Popescu, ACM TOMS 44, 2017, algorithm 6).
constexpr DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble s = two_sum(a.hi, b.hi);
    const DoubleDouble t = two_sum(a.lo, b.lo);
    const DoubleDouble v = quick_two_sum(s.hi, s.lo + t.hi);
    return quick_two_sum(v.hi, t.lo + v.lo);
}
constexpr DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }

/// Relative error at most 5 * 2^-106 (the same paper, algorithm 11).
constexpr DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble p = two_product(a.hi, b.hi);
    return quick_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/// Relative error at most 10 * 2^-106 (one Newton step on the leading quotient, and its rest).
constexpr DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double q1 = a.hi / b.hi;
    const DoubleDouble r = a - b * DoubleDouble(q1);
    const double q2 = r.hi / b.hi;
    const DoubleDouble r2 = r - b * DoubleDouble(q2);
    const DoubleDouble q = quick_two_sum(q1, q2);
    return q + DoubleDouble(r2.hi / b.hi);
}

constexpr DoubleDouble& operator+=(DoubleDouble& a, DoubleDouble b) { return a = a + b; }
constexpr DoubleDouble& operator-=(DoubleDouble& a, DoubleDouble b) { return a = a - b; }
constexpr DoubleDouble& operator*=(DoubleDouble& a, DoubleDouble b) { return a = a * b; }

constexpr bool operator<(DoubleDouble a, DoubleDouble b) {
    return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
}
constexpr bool operator>(DoubleDouble a, DoubleDouble b) { return b < a; }
constexpr bool operator<=(DoubleDouble a, DoubleDouble b) {
    return a.hi < b.hi || (a.hi == b.hi && a.lo <= b.lo);
}
constexpr bool operator>=(DoubleDouble a, DoubleDouble b) { return b <= a; }
constexpr bool operator==(DoubleDouble a, DoubleDouble b) { return a.hi == b.hi && a.lo == b.lo; }

/// a >= 0; below: NaN. One Newton step on the double root.
inline DoubleDouble sqrt(DoubleDouble a) {
    const double root = std::sqrt(a.hi);
    if (!(root > 0)) return {root, 0};
    const DoubleDouble rest = a - two_product(root, root);
    return quick_two_sum(root, rest.hi / (2 * root));
}

}  // namespace cobble::math
