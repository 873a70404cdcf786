// SPDX-License-Identifier: MIT
#include "renderer/shading/normal_map.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

using namespace cobble;
using ir::TextureFilter;
using math::Vec3;
using math::Vec3d;

namespace {

ir::Image flat_color(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    ir::Image image;
    image.width = 4;
    image.height = 4;
    image.tag = ir::ColorTag::kData;
    for (int i = 0; i < 16; ++i)
        for (const std::uint8_t c : std::array{r, g, b}) image.bytes.push_back(c);
    return image;
}

}  // namespace

TEST_CASE_TEMPLATE("128 128 255 is flat to the bit", T, float, double) {
    const ir::Image flat = flat_color(128, 128, 255);
    for (double u = -1; u < 1; u += 0.0771) {
        const Vec3d n = renderer::mapped_normal(flat, TextureFilter::kBilinear, {u, -3 * u});
        REQUIRE(n == Vec3d{0, 0, 1});
        const auto normal = math::normalize(Vec3d{u, 1, 0.3}).to<T>();
        CHECK(renderer::bend_normal(normal, Vec3<T>{1, 0, 0}, Vec3<T>{0, 0, -1}, n) == normal);
    }
    CHECK(renderer::bump_slope(flat, TextureFilter::kBilinear, {0.3, 0.4}) == math::Vec2d{0, 0});
    CHECK(renderer::mapped_normal(flat_color(255, 0, 0), TextureFilter::kNearest, {}) ==
          Vec3d{1, -1, -1});
}

TEST_CASE("red bends toward u, green toward v, in mirrored pictures too") {
    const Vec3d n{0, 1, 0};
    const Vec3d u{1, 0, 0};
    const Vec3d v{0, 0, -1};
    const Vec3d red = renderer::bend_normal(n, u, v, {1, 0, 1});
    CHECK(red.x == doctest::Approx(std::sqrt(0.5)));
    CHECK(red.y == doctest::Approx(std::sqrt(0.5)));
    const Vec3d green = renderer::bend_normal(n, u, v, {0, 1, 1});
    CHECK(green.z == doctest::Approx(-std::sqrt(0.5)));
    const Vec3d mirrored = renderer::bend_normal(n, u, -v, {0, 1, 1});
    CHECK(mirrored.z == doctest::Approx(std::sqrt(0.5)));
    const Vec3d reversed = renderer::bend_normal(n, -u, v, {1, 0, 1});
    CHECK(reversed.x == doctest::Approx(-std::sqrt(0.5)));
}

TEST_CASE_TEMPLATE("row 29: degenerate tangents fall back to any frame", T, float, double) {
    const auto n = math::normalize(Vec3d{0.2, -0.9, 0.4}).to<T>();
    const Vec3<T> zero;
    const Vec3<T> along = n * T(1e6);
    const Vec3<T> nearly = along + Vec3<T>{T(1), T(0), T(0)};
    const Vec3<T> x{1, 0, 0};
    for (const auto& [du, dv] :
         {std::pair{zero, zero}, std::pair{zero, x}, std::pair{along, x}, std::pair{x, x},
          std::pair{x, zero}, std::pair{nearly, zero}, std::pair{x * T(1e-30), x * T(1e30)}}) {
        const Vec3<T> bent = renderer::bend_normal(n, du, dv, {0.5, -0.3, 0.8});
        CHECK(std::fabs(static_cast<double>(math::length(bent)) - 1) < 1e-6);
        // The tilt is the map's, whichever way it goes.
        CHECK(static_cast<double>(math::dot(bent, n)) ==
              doctest::Approx(0.8 / std::sqrt(0.25 + 0.09 + 0.64)).epsilon(1e-5));
    }
    CHECK(renderer::bend_normal(n, x, x, {0, 0, 0}) == n);
}

TEST_CASE("a height map rises as its picture brightens") {
    // Height grows by 51 / 255 = 0.2 a texel to the right: 1 a repeat of five texels.
    ir::Image image;
    image.width = 5;
    image.height = 1;
    for (std::uint8_t i = 0; i < 5; ++i) {
        const auto value = static_cast<std::uint8_t>(51 * i);
        for (const std::uint8_t c : std::array{value, value, value}) image.bytes.push_back(c);
    }
    const math::Vec2d slope = renderer::bump_slope(image, TextureFilter::kBilinear, {0.5, 0.5});
    CHECK(slope.x == doctest::Approx(0.05 * 1));
    CHECK(slope.y == 0);
}
