// SPDX-License-Identifier: MIT
// What the build must keep of IEEE 754: expressions that compilers are known to change.
#include <doctest/doctest.h>

#include "ir/math/affine.hpp"
#include "ir/math/vec.hpp"

namespace cobble::test {

namespace {

// Not inlined, so that nothing is known of the arguments and the optimiser sees the bare pattern.
[[gnu::noinline]] math::Vec3d through_float(math::Vec3d a) { return a.to<float>().to<double>(); }
[[gnu::noinline]] math::Affined through_float(const math::Affined& a) {
    return a.to<float>().to<double>();
}
[[gnu::noinline]] double multiplied_and_added(double a, double b, double c) { return a * b + c; }

}  // namespace

TEST_CASE("narrowing to float and back rounds each number") {
    // One at a time there is nothing to vectorise.
    const volatile double third = 1.0 / 3;
    const volatile float narrow = static_cast<float>(third);
    const double expected{narrow};
    REQUIRE(expected != third);
    const math::Vec3d v = through_float(math::Vec3d{third, -third, third});
    CHECK(v == math::Vec3d{expected, -expected, expected});
    math::Affined a;
    for (auto& row : a.rows) {
        for (double& x : row) x = third;
    }
    for (const auto& row : through_float(a).rows) {
        for (const double x : row) CHECK(x == expected);
    }
}

TEST_CASE("a product is rounded before it is added to") {
    const double e = 0x1p-30;
    CHECK(multiplied_and_added(1 + e, 1 - e, -1) == 0);
}

}  // namespace cobble::test
