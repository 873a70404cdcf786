// SPDX-License-Identifier: MIT
#include "ir/lower/inverse.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cobble::ir {
namespace {

// A sum of two doubles that do not overlap.
struct Pair {
    double high = 0;
    double low = 0;
};

Pair two_sum(double a, double b) {
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

// Exact for factors whose products neither overflow nor underflow: they are at most some units
// here. The splitter is 2^27 + 1, which cuts 53 bits into halves.
Pair two_product(double a, double b) {
    constexpr double kSplitter = 134217729;
    const auto split = [](double x) {
        const double t = kSplitter * x;
        const double high = t - (t - x);
        return Pair{high, x - high};
    };
    const double product = a * b;
    const Pair x = split(a);
    const Pair y = split(b);
    const double error =
        ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low;
    return {product, error};
}

Pair add(Pair a, Pair b) {
    const Pair sum = two_sum(a.high, b.high);
    return two_sum(sum.high, sum.low + (a.low + b.low));
}

Pair multiply(double a, Pair b) {
    const Pair product = two_product(a, b.high);
    return two_sum(product.high, product.low + a * b.low);
}

double divide(Pair a, Pair b) {
    const double quotient = a.high / b.high;
    const Pair back = multiply(quotient, b);
    return quotient + (((a.high - back.high) - back.low) + a.low) / b.high;
}

using Matrix = std::array<std::array<double, 3>, 3>;

/// The exponent that brings the largest of three magnitudes near 1; none for zero or infinity.
std::optional<int> exponent_of(double a, double b, double c) {
    const double largest = std::max(std::max(std::fabs(a), std::fabs(b)), std::fabs(c));
    if (!(largest > 0) || !std::isfinite(largest)) return std::nullopt;
    return std::ilogb(largest);
}

double row_norm(const math::Affined& map) {
    double largest = 0;
    for (const auto& row : map.rows) {
        largest = std::max(largest, (std::fabs(row[0]) + std::fabs(row[1])) + std::fabs(row[2]));
    }
    return largest;
}

}  // namespace

std::optional<Inverse> invert(const math::Affined& map) {
    for (const auto& row : map.rows) {
        for (const double entry : row) {
            if (!std::isfinite(entry)) return std::nullopt;
        }
    }
    Matrix m;
    std::array<int, 3> row_exponent{};
    std::array<int, 3> column_exponent{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& row = map.rows[i];
        const auto exponent = exponent_of(row[0], row[1], row[2]);
        if (!exponent) return std::nullopt;
        row_exponent[i] = *exponent;
        for (std::size_t j = 0; j < 3; ++j) m[i][j] = std::ldexp(row[j], -*exponent);
    }
    for (std::size_t j = 0; j < 3; ++j) {
        const auto exponent = exponent_of(m[0][j], m[1][j], m[2][j]);
        if (!exponent) return std::nullopt;
        column_exponent[j] = *exponent;
        for (auto& row : m) row[j] = std::ldexp(row[j], -*exponent);
    }

    std::array<std::array<Pair, 3>, 3> cofactors;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const auto& a = m[(i + 1) % 3];
            const auto& b = m[(i + 2) % 3];
            const std::size_t p = (j + 1) % 3;
            const std::size_t q = (j + 2) % 3;
            cofactors[i][j] = add(two_product(a[p], b[q]), two_product(-a[q], b[p]));
        }
    }
    Pair determinant;
    for (std::size_t j = 0; j < 3; ++j) {
        determinant = add(determinant, multiply(m[0][j], cofactors[0][j]));
    }
    if (determinant.high == 0) return std::nullopt;

    Inverse result;
    result.mirrors = determinant.high < 0;
    auto& rows = result.map.rows;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const double entry = divide(cofactors[j][i], determinant);
            rows[i][j] = std::ldexp(entry, -row_exponent[j] - column_exponent[i]);
        }
        // Minus the inverse's row times the translation; scaled so that products stay in range.
        Pair sum;
        const auto scale = exponent_of(map.rows[0][3], map.rows[1][3], map.rows[2][3]);
        const auto size = exponent_of(rows[i][0], rows[i][1], rows[i][2]);
        if (scale && size) {
            for (std::size_t j = 0; j < 3; ++j) {
                sum = add(sum, two_product(std::ldexp(-rows[i][j], -*size),
                                           std::ldexp(map.rows[j][3], -*scale)));
            }
            rows[i][3] = std::ldexp(sum.high + sum.low, *scale + *size);
        }
        for (const double entry : rows[i]) {
            if (!std::isfinite(entry)) return std::nullopt;
        }
    }
    result.condition = row_norm(map) * row_norm(result.map);
    return result;
}

}  // namespace cobble::ir
