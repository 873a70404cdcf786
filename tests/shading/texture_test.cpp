// SPDX-License-Identifier: MIT
#include "renderer/shading/texture.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>

using namespace cobble;
using ir::Color;
using ir::TextureFilter;
using renderer::sample_texture;

namespace {

/// Red grows with x, green with y from the top.
ir::Image ramp(std::uint32_t width, std::uint32_t height) {
    ir::Image image;
    image.width = width;
    image.height = height;
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            for (const std::uint8_t c : std::array<std::uint8_t, 3>{
                     static_cast<std::uint8_t>(10 * x), static_cast<std::uint8_t>(10 * y), 255})
                image.bytes.push_back(c);
        }
    }
    return image;
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("texel centres lie at one half, v upwards") {
    const ir::Image image = ramp(3, 5);
    for (const TextureFilter filter : {TextureFilter::kBilinear, TextureFilter::kNearest}) {
        for (std::uint32_t y = 0; y < 5; ++y) {
            for (std::uint32_t x = 0; x < 3; ++x) {
                const Color color =
                    sample_texture(image, filter, {(x + 0.5) / 3, 1 - (y + 0.5) / 5});
                CHECK(color.x == doctest::Approx(10 * x / 255.0).epsilon(1e-12));
                CHECK(color.y == doctest::Approx(10 * y / 255.0).epsilon(1e-12));
                CHECK(color.z == 1);
            }
        }
    }
}

TEST_CASE("bilinear is the mean half-way, and wraps around the edge") {
    const ir::Image image = ramp(4, 1);
    const auto red = [&](double u) {
        return 255 * sample_texture(image, TextureFilter::kBilinear, {u, 0.5}).x;
    };
    CHECK(red(0.25) == doctest::Approx(5));
    CHECK(red(0.5) == doctest::Approx(15));
    CHECK(red(0.0) == doctest::Approx(15));  // between the first, 0, and the last, 30
    CHECK(red(1.0) == doctest::Approx(15));
    CHECK(red(-0.875 + 0.125) == doctest::Approx(red(0.25)));
}

TEST_CASE("row 36: coordinates wrap into range, wherever they are") {
    const ir::Image image = ramp(3, 5);
    const double below_one = std::nextafter(1.0, 0.0);
    const double below_zero = -std::numeric_limits<double>::denorm_min();
    const auto red = [&](double u) {
        return std::lround(255 * sample_texture(image, TextureFilter::kNearest, {u, 0.5}).x);
    };
    CHECK(renderer::wrap_unit(below_zero) < 1);
    CHECK(renderer::wrap_unit(-0x1p-60) > 0.999);
    CHECK(renderer::wrap_unit(-0.25) == 0.75);
    CHECK(red(below_one) == 20);
    CHECK(red(1.0) == 0);
    CHECK(red(-0.0) == 0);
    CHECK(red(below_zero) == 20);
    CHECK(red(-below_one) == 0);
    CHECK(red(1e9) == 0);
    CHECK(red(1e9 + 0.5) == 10);
    CHECK(red(-1e9 - 0.1) == 20);
    for (const double u : {below_one, below_zero, 1e9, -1e9, 1e300, -1e300, 0x1p52 + 0.5}) {
        for (const TextureFilter filter : {TextureFilter::kBilinear, TextureFilter::kNearest}) {
            for (const ir::Image& any : {ramp(1, 1), ramp(3, 5), ramp(1, 7), ramp(2, 2)}) {
                const Color color = sample_texture(any, filter, {u, -u});
                CHECK(color.z == 1);
                CHECK(color.x >= 0);
                CHECK(color.x <= 20 / 255.0);
            }
        }
    }
}

TEST_CASE("row 36: coordinates that are no numbers show as an error") {
    const ir::Image image = ramp(2, 2);
    for (const double bad : {kNaN, kInfinity, -kInfinity}) {
        CHECK(sample_texture(image, TextureFilter::kBilinear, {bad, 0}) == renderer::kErrorColor);
        CHECK(sample_texture(image, TextureFilter::kNearest, {0, bad}) == renderer::kErrorColor);
    }
}

TEST_CASE("a picture of one colour is that colour to the bit") {
    ir::Image image;
    image.width = 3;
    image.height = 2;
    for (int i = 0; i < 6; ++i)
        for (const std::uint8_t c : std::array<std::uint8_t, 3>{77, 128, 255})
            image.bytes.push_back(c);
    for (double u = -2; u < 2; u += 0.0371) {
        const Color color = sample_texture(image, TextureFilter::kBilinear, {u, 3 * u});
        CHECK(color == Color{77 / 255.0, 128 / 255.0, 1});
        CHECK(renderer::sample_data(image, TextureFilter::kBilinear, {u, 3 * u}) ==
              math::Vec3d{77, 128, 255});
    }
}

TEST_CASE("float pictures keep their numbers") {
    ir::Image image;
    image.width = 1;
    image.height = 1;
    image.floats = {12.5F, 0.25F, 1000.0F};
    CHECK(sample_texture(image, TextureFilter::kBilinear, {0.3, 0.3}) == Color{12.5, 0.25, 1000});
}

TEST_CASE("a missing picture is a checker nobody overlooks") {
    ir::Image image;
    image.missing = true;
    const Color a = sample_texture(image, TextureFilter::kBilinear, {0.01, 0.01});
    const Color b = sample_texture(image, TextureFilter::kBilinear, {0.13, 0.01});
    CHECK(a == renderer::kErrorColor);
    CHECK(b == Color{});
    CHECK(sample_texture(image, TextureFilter::kBilinear, {0.13, 0.13}) == a);
    CHECK(sample_texture(image, TextureFilter::kBilinear, {-0.01, 0.01}) == b);
}
