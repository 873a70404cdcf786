// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "ir/math/inverse.hpp"
#include "tests/support/record.hpp"

using namespace cobble;
using math::Affined;
using math::invert;

namespace {

constexpr double kUnit = 0x1p-53;

/// Largest entry of |inverse map - 1|, summed in long double; the translation in units of its
/// size.
double residual(const Affined& map, const Affined& inverse) {
    long double worst = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            long double sum = j == 3 ? static_cast<long double>(inverse.rows[i][3]) : 0;
            long double size = std::fabs(sum);
            for (std::size_t k = 0; k < 3; ++k) {
                const long double term =
                    static_cast<long double>(inverse.rows[i][k]) * map.rows[k][j];
                sum += term;
                size += std::fabs(term);
            }
            if (i == j) sum -= 1;
            worst = std::max(worst, j == 3 && size > 0 ? std::fabs(sum) / size : std::fabs(sum));
        }
    }
    return static_cast<double>(worst);
}

Affined random_map(std::mt19937& random) {
    std::uniform_real_distribution<double> entry(-1, 1);
    Affined map;
    for (auto& row : map.rows) {
        for (double& x : row) x = entry(random);
    }
    return map;
}

Affined scale(double x, double y, double z) {
    Affined map;
    map.rows[0][0] = x;
    map.rows[1][1] = y;
    map.rows[2][2] = z;
    return map;
}

}  // namespace

TEST_CASE("row 26: the inverse is right to 64 units times the condition") {
    std::mt19937 random(11);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const Affined a = random_map(random);
        Affined map = a;
        if (i % 4 == 1) map = a * scale(1e-6, 1, 1e6);
        if (i % 4 == 2) map = a * scale(1, 1e-7, 1) * random_map(random);
        if (i % 4 == 3) map = scale(1e150, 1e150, 1e150) * a;
        const auto inverse = invert(map);
        REQUIRE(inverse);
        REQUIRE(residual(map, inverse->map) <= 64 * kUnit * inverse->condition);
        worst = std::max(worst, residual(map, inverse->map) / (kUnit * inverse->condition));
    }
    // Twice the working precision pays: in plain doubles the cofactors alone give 18.
    CHECK(worst <= 4);
    test::record(26, "residual " + test::brief(worst) + "u times the condition at most");
}

TEST_CASE("powers of two and permutations are inverted exactly") {
    const auto half = invert(scale(2, -4, 0.5));
    REQUIRE(half);
    CHECK(half->map == scale(0.5, -0.25, 2));
    CHECK(half->mirrors);
    CHECK(half->condition == 8);
    Affined turn;
    turn.rows = {{{0, 0, 1, 5}, {0, 1, 0, 6}, {-1, 0, 0, 7}}};
    const auto back = invert(turn);
    REQUIRE(back);
    Affined expected;
    expected.rows = {{{0, 0, -1, 7}, {0, 1, 0, -6}, {1, 0, 0, -5}}};
    CHECK(back->map == expected);
    CHECK(!back->mirrors);
}

TEST_CASE("row 26: extreme scales are inverted, singular maps are not") {
    CHECK(invert(scale(1e-300, 1e300, 1)));
    CHECK(invert(scale(1e-300, 1e-300, 1e-300)));
    // Two rows whose products alone would vanish, and a translation beyond what they can carry.
    Affined turn;
    turn.rows = {{{1, 1, 0, 0}, {1, -1, 0, 0}, {0, 1, 1, 1e300}}};
    const Affined narrow = scale(1e-200, 1e-200, 1) * turn;
    REQUIRE(invert(narrow));
    CHECK(residual(narrow, invert(narrow)->map) <= 64 * kUnit * invert(narrow)->condition);
    CHECK(residual(narrow, invert(narrow)->map) < 1e-14);
    CHECK(!invert(scale(0, 1, 1)));
    CHECK(!invert(scale(1e-320, 1, 1)));  // the inverse overflows
    Affined map;
    map.rows = {{{1, 2, 3, 0}, {2, 4, 6, 0}, {0, 0, 1, 0}}};
    CHECK(!invert(map));
    map.rows[0][0] = std::nan("");
    CHECK(!invert(map));
    map.rows[0][0] = INFINITY;
    CHECK(!invert(map));
}
