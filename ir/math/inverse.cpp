// SPDX-License-Identifier: MIT
#include "ir/math/inverse.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "ir/math/double_double.hpp"
#include "ir/math/kernels.hpp"

namespace cobble::math {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

/// The exponent that brings the largest of three magnitudes near 1; none if all are zero.
std::optional<int> common_exponent(double a, double b, double c) {
    double most = 0;
    for (const double x : {std::fabs(a), std::fabs(b), std::fabs(c)}) most = x > most ? x : most;
    if (most == 0) return std::nullopt;
    return detail::exponent(most);
}

}  // namespace

std::optional<Inverse> invert(const Affined& map) {
    for (const auto& row : map.rows) {
        for (const double x : row) {
            if (!std::isfinite(x)) return std::nullopt;
        }
    }
    // A = R B S with powers of two on the diagonals of R and S, so that no product leaves the
    // range; A^-1 = S^-1 B^-1 R^-1.
    Matrix m;
    std::array<int, 3> row_shift{};
    std::array<int, 3> column_shift{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& row = map.rows[i];
        const auto exponent = common_exponent(row[0], row[1], row[2]);
        if (!exponent) return std::nullopt;
        row_shift[i] = *exponent;
        for (std::size_t j = 0; j < 3; ++j) m[i][j] = detail::scale(row[j], -*exponent);
    }
    std::array<std::array<DoubleDouble, 3>, 3> b;
    for (std::size_t j = 0; j < 3; ++j) {
        const auto exponent = common_exponent(m[0][j], m[1][j], m[2][j]);
        if (!exponent) return std::nullopt;
        column_shift[j] = *exponent;
        for (std::size_t i = 0; i < 3; ++i)
            b[i][j] = DoubleDouble(detail::scale(m[i][j], -*exponent));
    }
    const auto minor = [&b](std::size_t r0, std::size_t r1, std::size_t c0, std::size_t c1) {
        return b[r0][c0] * b[r1][c1] - b[r0][c1] * b[r1][c0];
    };
    std::array<std::array<DoubleDouble, 3>, 3> cofactors;  // transposed
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            cofactors[j][i] = minor((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        }
    }
    const DoubleDouble det =
        (b[0][0] * cofactors[0][0] + b[0][1] * cofactors[1][0]) + b[0][2] * cofactors[2][0];
    if (det == DoubleDouble(0)) return std::nullopt;
    // The translation as B^-1 meets it: R^-1 t, of which the largest is brought near 1.
    std::array<int, 3> shift{};
    int away = 0;
    bool moves = false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (map.rows[i][3] == 0) continue;
        shift[i] = detail::exponent(map.rows[i][3]) - row_shift[i];
        away = !moves || shift[i] > away ? shift[i] : away;
        moves = true;
    }
    Inverse result;
    result.mirrors = det < DoubleDouble(0);
    for (std::size_t i = 0; i < 3; ++i) {
        auto& out = result.map.rows[i];
        DoubleDouble back;
        for (std::size_t j = 0; j < 3; ++j) {
            const DoubleDouble entry = cofactors[i][j] / det;
            out[j] = detail::scale(entry.hi, -column_shift[i] - row_shift[j]);
            back -= entry * DoubleDouble(detail::scale(map.rows[j][3], -row_shift[j] - away));
        }
        out[3] = detail::scale(back.hi, away - column_shift[i]);
        for (const double x : out) {
            if (!std::isfinite(x)) return std::nullopt;
        }
    }
    result.condition = condition(map, result.map);
    return result;
}

std::optional<Affined> inverse(const Affined& map) {
    const auto result = invert(map);
    if (!result) return std::nullopt;
    return result->map;
}

double condition(const Affined& map, const Affined& inverse_map) {
    const auto norm = [](const Affined& m) {
        double most = 0;
        for (const auto& row : m.rows) {
            const double sum = (std::fabs(row[0]) + std::fabs(row[1])) + std::fabs(row[2]);
            if (sum > most) most = sum;
        }
        return most;
    };
    return norm(map) * norm(inverse_map);
}

}  // namespace cobble::math
