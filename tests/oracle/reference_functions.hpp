// SPDX-License-Identifier: MIT
// Elementary functions in double-double, the slow and obvious way: what ir/math is compared with.
// Nothing here is shared with it but the arithmetic of double-double itself. Results are good to
// some 2^-95 of themselves.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "ir/math/double_double.hpp"

namespace cobble::oracle {

using Dd = math::DoubleDouble;

// To 106 bits, from their binary expansions.
inline constexpr Dd kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
inline constexpr Dd kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
inline constexpr Dd kLn2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

inline Dd times_power(Dd a, int k) { return {std::ldexp(a.hi, k), std::ldexp(a.lo, k)}; }

/// Taylor series of e^x - 1 at x / 256, then eight times (1 + y)^2 - 1 = y (2 + y).
inline Dd exp_minus_1_small(Dd x) {
    const Dd r = times_power(x, -8);
    Dd term = r;
    Dd sum = r;
    for (int n = 2; n < 20; ++n) {
        term = term * r / Dd(n);
        sum += term;
    }
    for (int i = 0; i < 8; ++i) sum = sum * (Dd(2) + sum);
    return sum;
}

struct Scaled {
    Dd value;  ///< times 2^exponent
    int exponent = 0;
};

/// e^x as a number around 1 and a power of two, so that nothing is lost to underflow.
inline Scaled exp_scaled(Dd x) {
    const double k = std::nearbyint(x.hi / kLn2.hi);
    return {Dd(1) + exp_minus_1_small(x - kLn2 * Dd(k)), static_cast<int>(k)};
}

/// Newton on e^y = x from the C library's value: twice the digits in one step, and one to spare.
inline Dd log(double x) {
    Dd y(std::log(x));
    for (int i = 0; i < 2; ++i) {
        if (x > 0.5 && x < 2) {
            // Around 1 the ratio less 1 must not cancel: x (e^-y - 1) + (x - 1).
            y += Dd(x) * exp_minus_1_small(-y) + (Dd(x) - Dd(1));
            continue;
        }
        const Scaled e = exp_scaled(-y);
        int k = 0;
        const double m = std::frexp(x, &k);
        const Dd ratio = times_power(Dd(m) * e.value, k + e.exponent);
        // log(1 + d) = d - d^2 / 2: d is some 2^-52.
        const Dd d = ratio - Dd(1);
        y += d - times_power(d * d, -1);
    }
    return y;
}

struct SinCosDd {
    Dd sin, cos;
};

/// Taylor series; |x| <= pi / 4.
inline SinCosDd sincos_small(Dd x) {
    const Dd z = x * x;
    Dd term = x;
    Dd s = x;
    for (int n = 1; n < 16; ++n) {
        term = -(term * z) / Dd((2.0 * n) * (2.0 * n + 1));
        s += term;
    }
    term = Dd(1);
    Dd c(1);
    for (int n = 1; n < 16; ++n) {
        term = -(term * z) / Dd((2.0 * n - 1) * (2.0 * n));
        c += term;
    }
    return {s, c};
}

inline SinCosDd turned(SinCosDd a, unsigned quadrant) {
    if ((quadrant & 2U) != 0) a = {-a.sin, -a.cos};
    if ((quadrant & 1U) != 0) a = {a.cos, -a.sin};
    return a;
}

/// pi / 2 to 2400 bits, as an integer of 32-bit words, the least first; by Machin's formula,
/// pi / 4 = 4 atan(1/5) - atan(1/239), in whole numbers.
inline const std::vector<std::uint32_t>& half_pi_bits() {
    static const std::vector<std::uint32_t> bits = [] {
        constexpr std::size_t kWords = 78;  // 76 of fraction, two to grow into
        using Big = std::vector<std::uint32_t>;
        const auto divide = [](Big& a, std::uint32_t d) {
            std::uint64_t rest = 0;
            for (std::size_t i = kWords; i-- > 0;) {
                const std::uint64_t x = (rest << 32) | a[i];
                a[i] = static_cast<std::uint32_t>(x / d);
                rest = x % d;
            }
        };
        const auto add = [](Big& a, const Big& b, bool minus) {
            std::uint64_t carry = minus ? 1 : 0;
            for (std::size_t i = 0; i < kWords; ++i) {
                carry += std::uint64_t{a[i]} + (minus ? static_cast<std::uint32_t>(~b[i]) : b[i]);
                a[i] = static_cast<std::uint32_t>(carry);
                carry >>= 32;
            }
        };
        const auto add_atan = [&](Big& sum, std::uint32_t factor, std::uint32_t n, bool minus) {
            Big power(kWords, 0);
            power[76] = factor;
            divide(power, n);
            for (std::uint32_t k = 1; k < 2400; k += 2) {
                Big term = power;
                divide(term, k);
                add(sum, term, minus != (k % 4 == 3));
                divide(power, n);
                divide(power, n);
            }
        };
        Big sum(kWords, 0);
        add_atan(sum, 8, 5, false);
        add_atan(sum, 2, 239, true);
        return sum;
    }();
    return bits;
}

/// Any finite x: the remainder of a long division of whole numbers, x 2^2432 by pi/2 2^2432.
inline SinCosDd sincos(double x) {
    if (std::fabs(x) < 0.78) return sincos_small(Dd(x));
    int e = 0;
    const double m = std::frexp(std::fabs(x), &e);
    const auto mantissa = static_cast<std::uint64_t>(std::ldexp(m, 53));
    e -= 53;
    // Remainder r < d, fed bit by bit: first the mantissa, then the zeros that follow it.
    const auto& d = half_pi_bits();
    const std::size_t words = d.size();
    std::vector<std::uint32_t> r(words, 0);
    unsigned quadrant = 0;
    const int total = 2432 + e;  // zeros after the mantissa
    for (int bit = 52; bit >= -total; --bit) {
        std::uint32_t carry = bit >= 0 ? static_cast<std::uint32_t>((mantissa >> bit) & 1U) : 0U;
        for (auto& w : r) {
            const std::uint32_t top = w >> 31;
            w = (w << 1) | carry;
            carry = top;
        }
        bool at_least = true;
        for (std::size_t i = words; i-- > 0;) {
            if (r[i] == d[i]) continue;
            at_least = r[i] > d[i];
            break;
        }
        quadrant = (quadrant << 1) | (at_least ? 1U : 0U);
        if (!at_least) continue;
        std::uint64_t borrow = 1;
        for (std::size_t i = 0; i < words; ++i) {
            borrow += std::uint64_t{r[i]} + static_cast<std::uint32_t>(~d[i]);
            r[i] = static_cast<std::uint32_t>(borrow);
            borrow >>= 32;
        }
    }
    Dd rest;
    for (std::size_t i = words; i-- > 0;) {
        rest += Dd(std::ldexp(static_cast<double>(r[i]), 32 * static_cast<int>(i) - 2432));
    }
    if (rest.hi > 0.79) {
        rest = rest - kHalfPi;
        quadrant += 1;
    }
    SinCosDd a = turned(sincos_small(rest), quadrant);
    if (x < 0) a.sin = -a.sin;
    return a;
}

/// The angle of (x, y): Newton on the rotation that brings it to the x axis, from the C library's
/// value. For numbers whose squares stay in range.
inline Dd angle(Dd y, Dd x) {
    Dd a(std::atan2(y.hi, x.hi));
    for (int i = 0; i < 2; ++i) {
        const int turns = a.hi > 0.78    ? (a.hi > 2.35 ? 2 : 1)
                          : a.hi < -0.78 ? (a.hi < -2.35 ? -2 : -1)
                                         : 0;
        const SinCosDd r =
            turned(sincos_small(a - kHalfPi * Dd(turns)), static_cast<unsigned>(turns) & 3U);
        a += (y * r.cos - x * r.sin) / (x * r.cos + y * r.sin);
    }
    return a;
}

}  // namespace cobble::oracle
