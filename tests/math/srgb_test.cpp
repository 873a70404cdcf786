// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "ir/math/srgb.hpp"

namespace cobble::math {
namespace {

TEST_CASE("the standard's curve from display values to light") {
    CHECK(srgb_to_linear(0.0) == 0.0);
    CHECK(srgb_to_linear(1.0) == 1.0);
    CHECK(srgb_to_linear(0.5) == doctest::Approx(0.21404114048223255).epsilon(1e-14));
    CHECK(srgb_to_linear(0.04) == doctest::Approx(0.04 / 12.92).epsilon(1e-15));
    CHECK(srgb_to_linear(-0.5) == -srgb_to_linear(0.5));
    CHECK(srgb_to_linear(2.0) > srgb_to_linear(1.0));
    CHECK(srgb_to_linear(Vec3d{0.5, 1, 0}) == Vec3d{srgb_to_linear(0.5), 1, 0});
}

}  // namespace
}  // namespace cobble::math
