// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>

#include "ir/math/elementary.hpp"
#include "ir/math/kernels.hpp"

namespace cobble::math {

namespace {

using detail::Reduced;
using detail::SinCosDd;

/// 2 / pi in binary, 32 bits a word, from the bit of weight 1/2 down: 1280 bits. A double's last
/// bit weighs up to 2^971, so that a product's bits down to 2^-130 need the first 1140 or so.
constexpr std::array<std::uint32_t, 40> kTwoOverPi{
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab, 0xf0cfbc20, 0x9af4361d};

/// 32 bits of 2 / pi whose first has weight 2^-`first`; zeros outside the table.
std::uint32_t two_over_pi_bits(int first) {
    const auto word = [](int index) -> std::uint64_t {
        return index < 0 || index >= static_cast<int>(kTwoOverPi.size())
                   ? 0
                   : kTwoOverPi[static_cast<std::size_t>(index)];
    };
    const int zero_based = first - 1 + 32;  // never negative: first > -32
    const int index = zero_based / 32 - 1;
    const std::uint64_t both = (word(index) << 32) | word(index + 1);
    return static_cast<std::uint32_t>(both >> (32 - zero_based % 32));
}

/// Payne and Hanek (SIGNUM Newsletter 18, 1983): multiplies the integer significand by the part of
/// 2 / pi that matters modulo 4, in integers.
Reduced reduce_large(double x) {
    const int e = detail::exponent(x) - 52;  // |x| = m 2^e with 53-bit m
    const auto m = (std::bit_cast<std::uint64_t>(x) & 0x000fffffffffffffU) | 0x0010000000000000U;
    // A bit of 2 / pi with weight 2^-i adds m 2^(e - i): multiples of 4 where e - i >= 2.
    const int first = e - 1;
    constexpr int kWords = 6;  // 192 bits: what is left out is below m 2^-190 < 2^-137
    // product[0] holds the least 32 bits.
    std::array<std::uint64_t, kWords + 2> product{};
    const std::array<std::uint64_t, 2> factor{m & 0xffffffffU, m >> 32};
    for (int i = 0; i < kWords; ++i) {
        const std::uint64_t bits = two_over_pi_bits(first + 32 * (kWords - 1 - i));
        for (std::size_t j = 0; j < 2; ++j) {
            std::uint64_t carry = bits * factor[j];
            for (std::size_t k = static_cast<std::size_t>(i) + j; k < product.size(); ++k) {
                const std::uint64_t sum = product[k] + (carry & 0xffffffffU);
                product[k] = sum & 0xffffffffU;
                carry = (carry >> 32) + (sum >> 32);
            }
        }
    }
    // The window's first bit has weight 2 in x 2 / pi, its last 2^-190: bits 191 and 190 of the
    // product are the quadrant, the rest is a fraction of one.
    auto quadrant = static_cast<unsigned>(product[5] >> 30);
    std::array<std::uint64_t, 6> fraction{product[0], product[1], product[2],
                                          product[3], product[4], product[5] & 0x3fffffffU};
    const bool negative = (fraction[5] >> 29) != 0;  // above one half: take the next quadrant
    if (negative) {
        quadrant += 1;
        std::uint64_t carry = 1;
        for (auto& word : fraction) {
            word = (~word & 0xffffffffU) + carry;
            carry = word >> 32;
            word &= 0xffffffffU;
        }
        fraction[5] &= 0x3fffffffU;
    }
    DoubleDouble f;
    double weight = 0x1p-30;
    for (int i = 5; i >= 0; --i) {
        f += DoubleDouble(static_cast<double>(fraction[static_cast<std::size_t>(i)]) * weight);
        weight *= 0x1p-32;
    }
    DoubleDouble rest = f * detail::kHalfPiDd;
    if (negative) rest = -rest;
    return x < 0 ? Reduced{-rest, (0U - quadrant) & 3U} : Reduced{rest, quadrant & 3U};
}

SinCosDd rotate(SinCosDd a, unsigned quadrant) {
    switch (quadrant & 3U) {
        case 0:
            return a;
        case 1:
            return {a.cos, -a.sin};
        case 2:
            return {-a.sin, -a.cos};
        default:
            return {-a.cos, a.sin};
    }
}

SinCosDd sincos_dd(double x) {
    const Reduced r = detail::reduce_half_pi(x);
    return rotate(detail::sincos_kernel(r.rest), r.quadrant);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
/// Below this sin x and tan x round to x, and x^3 could underflow on the way.
constexpr double kTiny = 0x1p-30;

}  // namespace

SinCosDd detail::sincos_kernel(DoubleDouble x) {
    const DoubleDouble square = x * x;
    const double z = square.hi;
    // Coefficients 1 / n! with alternating signs, least first.
    const double s =
        z * (1.0 / 120 + z * (-1.0 / 5040 +
                              z * (1.0 / 362880 + z * (-1.0 / 39916800 +
                                                       z * (1.0 / 6227020800 +
                                                            z * (-1.0 / 1307674368000 +
                                                                 z * (1.0 / 355687428096000)))))));
    const double c =
        z * z *
        (1.0 / 24 +
         z * (-1.0 / 720 +
              z * (1.0 / 40320 +
                   z * (-1.0 / 3628800 +
                        z * (1.0 / 479001600 +
                             z * (-1.0 / 87178291200 +
                                  z * (1.0 / 20922789888000 + z * (-1.0 / 6402373705728000))))))));
    // sin: x + (x^3 (-1/6 + s) + lo (1 - x^2 / 2)); cos: (1 - x^2 / 2) + c.
    const double tail = x.hi * z * (s - 1.0 / 6) + x.lo * (1 - 0.5 * z);
    const DoubleDouble head = quick_two_sum(1, -0.5 * z);
    return {quick_two_sum(x.hi, tail), quick_two_sum(head.hi, head.lo - 0.5 * square.lo + c)};
}

Reduced detail::reduce_half_pi(double x) {
    if (std::fabs(x) <= 0.7853981633974483) return {DoubleDouble(x), 0};
    if (std::fabs(x) >= 0x1p20) return reduce_large(x);
    // Cody and Waite: pi / 2 in parts of 33, 33 and 53 bits. n has at most 20, so that the first
    // two products and the first difference are exact.
    const double n = std::floor(x * 0x1.45f306dc9c883p-1 + 0.5);
    const DoubleDouble a = two_sum(x - n * 0x1.921fb544p+0, -(n * 0x1.0b4611a6p-34));
    const DoubleDouble rest = a + -two_product(n, 0x1.3198a2e037073p-69);
    return {rest, static_cast<unsigned>(static_cast<int>(n)) & 3U};
}

double sin(double x) {
    if (!(std::fabs(x) <= std::numeric_limits<double>::max())) return kNan;
    if (std::fabs(x) < kTiny) return x;
    return sincos_dd(x).sin.hi;
}

double cos(double x) {
    if (!(std::fabs(x) <= std::numeric_limits<double>::max())) return kNan;
    return sincos_dd(x).cos.hi;
}

double tan(double x) {
    if (!(std::fabs(x) <= std::numeric_limits<double>::max())) return kNan;
    if (std::fabs(x) < kTiny) return x;
    const SinCosDd a = sincos_dd(x);
    return (a.sin / a.cos).hi;
}

SinCos sincos(double x) {
    if (!(std::fabs(x) <= std::numeric_limits<double>::max())) return {kNan, kNan};
    const SinCosDd a = sincos_dd(x);
    return {std::fabs(x) < kTiny ? x : a.sin.hi, a.cos.hi};
}

SinCos sincos_degrees(double degrees) {
    if (!(std::fabs(degrees) <= std::numeric_limits<double>::max())) return {kNan, kNan};
    // The remainder of a division is exact by definition. So is what follows: both are multiples
    // of the remainder's last bit, and the difference is no longer than the remainder.
    const double turn = std::fmod(degrees, 360.0);
    const double n = std::floor(turn / 90 + 0.5);
    const double rest = turn - 90 * n;
    constexpr DoubleDouble kDegree{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};
    // Where x^3 and the low part of the product vanish, the product itself is the answer.
    const DoubleDouble x =
        std::fabs(rest) < 0x1p-900 ? DoubleDouble(rest * kDegree.hi) : DoubleDouble(rest) * kDegree;
    const SinCosDd a = rotate(detail::sincos_kernel(x), static_cast<unsigned>(static_cast<int>(n)));
    // + 0: a quarter turn's zero is +0 whichever way it came.
    return {a.sin.hi + 0.0, a.cos.hi + 0.0};
}

}  // namespace cobble::math
