// SPDX-License-Identifier: MIT
// Quick directions are either those of the definition to the bit, or said to be unsure.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "ir/math/vec.hpp"
#include "renderer/integrator/quick_unit.hpp"
#include "renderer/sampling/hash.hpp"

using cobble::math::Vec3d;
using namespace cobble::renderer;

namespace {

double number(std::uint64_t key) { return static_cast<double>(mix64(key) >> 11U) * 0x1p-52 - 1; }

Vec3d direction(std::uint64_t key) {
    return {number(3 * key), number(3 * key + 1), number(3 * key + 2)};
}

bool same_bits(cobble::math::Vec3<float> a, cobble::math::Vec3<float> b) {
    return std::bit_cast<std::uint32_t>(a.x) == std::bit_cast<std::uint32_t>(b.x) &&
           std::bit_cast<std::uint32_t>(a.y) == std::bit_cast<std::uint32_t>(b.y) &&
           std::bit_cast<std::uint32_t>(a.z) == std::bit_cast<std::uint32_t>(b.z);
}

bool right(Vec3d a) { return same_bits(quick_unit(a).direction, normalize(a).to<float>()); }

struct Tally {
    int unsure = 0;
    int wrong = 0;

    void add(Vec3d a) {
        if (quick_unit(a).unsure != 0) {
            ++unsure;
        } else if (!right(a)) {
            ++wrong;
        }
    }
};

}  // namespace

TEST_CASE("quick directions are the definition's bits, and seldom unsure") {
    Tally tally;
    constexpr std::uint64_t kMany = 400000;
    for (std::uint64_t i = 0; i < kMany; ++i) {
        const Vec3d a = direction(i) * std::ldexp(1.0, static_cast<int>(i % 41) - 20);
        tally.add(a);
    }
    CHECK(tally.wrong == 0);
    CHECK(tally.unsure < 40);
}

TEST_CASE("quick directions between two floats are unsure where the definition rounds otherwise") {
    // Close by a place where a component lies just between two floats: |a| = 1 but for what makes
    // it so, and x there to the last bits of double.
    Tally tally;
    for (std::uint64_t i = 0; i < 100000; ++i) {
        const auto x = static_cast<float>(0.5 + 0.4 * std::fabs(number(2 * i)));
        const double between =
            (double{x} + std::nextafter(x, std::numeric_limits<float>::infinity())) / 2;
        const double near = between * (1 + number(2 * i + 1) * 0x1p-46);
        const Vec3d a{near, std::sqrt(1 - near * near), 0};
        tally.add(a);
    }
    CHECK(tally.wrong == 0);
    CHECK(tally.unsure > 90000);
}

TEST_CASE("directions that float has no root of are unsure") {
    for (const double length : {0.0, 1e-160, 1e-60, 1e-25, 1e25, 1e60, 1e160}) {
        CAPTURE(length);
        CHECK(quick_unit(Vec3d{0.6, -0.64, 0.48} * length).unsure == 1);
    }
    CHECK(quick_unit(Vec3d{0, 0, 0}).unsure == 1);
    const double inf = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(quick_unit(Vec3d{inf, 0, 0}).unsure == 1);
    CHECK(quick_unit(Vec3d{nan, 0, 1}).unsure == 1);
    CHECK(right({0, -0.0, -3}));
    CHECK(quick_unit(Vec3d{0, -0.0, -3}).unsure == 0);
}
