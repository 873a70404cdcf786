// SPDX-License-Identifier: MIT
// Decimal text to the nearest double, quickly for the short numbers that meshes are made of.
#pragma once

#include <fast_float/fast_float.h>

#include <array>
#include <cstdint>

#include "frontend/check/single.hpp"

namespace cobble::ir {

inline bool is_digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }

using frontend::fits_single;

/// Reads `[+-]?(digits[.digits?]|.digits)([eE][+-]?digits)?` at `p`; the text must be followed by a
/// byte that is no part of a number (a std::string's final zero will do). Gives the end, or null if
/// no number stands there. The value may be infinite if the number is too large.
///
/// Up to 19 digits fit 64 bits; where they fit 53 and the power of ten is at most 22, both are
/// exact doubles and one division rounds correctly (Clinger, "How to read floating point numbers
/// accurately", PLDI 1990). The rest goes to fast_float.
inline const char* scan_number(const char* p, double& value) {
    static constexpr std::array<double, 23> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                    1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                    1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const bool negative = *p == '-';
    if (negative || *p == '+') ++p;
    const char* const begin = p;
    std::uint64_t digits = 0;
    for (; is_digit(*p); ++p) digits = digits * 10 + static_cast<std::uint64_t>(*p - '0');
    auto count = p - begin;
    std::ptrdiff_t fraction = 0;
    if (*p == '.') {
        const char* const first = ++p;
        for (; is_digit(*p); ++p) digits = digits * 10 + static_cast<std::uint64_t>(*p - '0');
        fraction = p - first;
        count += fraction;
    }
    if (count == 0) return nullptr;
    const bool has_exponent = (*p | 0x20) == 'e';
    if (!has_exponent && count <= 19 && fraction <= 22 && digits <= (std::uint64_t{1} << 53)) {
        const double result =
            static_cast<double>(digits) / kPowers[static_cast<std::size_t>(fraction)];
        value = negative ? -result : result;
        return p;
    }
    if (has_exponent) {
        ++p;
        if (*p == '-' || *p == '+') ++p;
        const char* const first = p;
        while (is_digit(*p)) ++p;
        if (p == first) return nullptr;
    }
    double result = 0;
    fast_float::from_chars(begin, p, result);
    value = negative ? -result : result;
    return p;
}

}  // namespace cobble::ir
