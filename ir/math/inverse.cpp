// SPDX-License-Identifier: MIT
#include "ir/math/inverse.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "ir/math/double_double.hpp"
#include "ir/math/kernels.hpp"

namespace cobble::math {

std::optional<Affined> inverse(const Affined& map) {
    // Columns scaled to around 1 by powers of two, so that no product leaves the range:
    // A = B S, A^-1 = S^-1 B^-1.
    std::array<int, 3> shift{};
    std::array<std::array<DoubleDouble, 3>, 3> b;
    for (std::size_t j = 0; j < 3; ++j) {
        double most = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double x = std::fabs(map.rows[i][j]);
            if (!(x <= std::numeric_limits<double>::max())) return std::nullopt;
            if (x > most) most = x;
        }
        if (most == 0) return std::nullopt;
        shift[j] = detail::exponent(most);
        for (std::size_t i = 0; i < 3; ++i) {
            b[i][j] = DoubleDouble(detail::scale(map.rows[i][j], -shift[j]));
        }
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
    Affined result;
    for (std::size_t i = 0; i < 3; ++i) {
        std::array<DoubleDouble, 3> row;
        for (std::size_t j = 0; j < 3; ++j) row[j] = cofactors[i][j] / det;
        const DoubleDouble back =
            -((row[0] * DoubleDouble(map.rows[0][3]) + row[1] * DoubleDouble(map.rows[1][3])) +
              row[2] * DoubleDouble(map.rows[2][3]));
        for (std::size_t j = 0; j < 3; ++j) {
            result.rows[i][j] = detail::scale(row[j].hi, -shift[i]);
        }
        result.rows[i][3] = detail::scale(back.hi, -shift[i]);
        for (const double x : result.rows[i]) {
            if (!(std::fabs(x) <= std::numeric_limits<double>::max())) return std::nullopt;
        }
    }
    return result;
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
