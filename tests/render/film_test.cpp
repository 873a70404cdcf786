// SPDX-License-Identifier: MIT
#include "renderer/film/film.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "tests/support/record.hpp"

using namespace cobble;
using renderer::PixelAccumulator;
using renderer::Sample;

namespace {

Sample grey(double value) {
    Sample sample;
    sample.color = {value, value, value};
    return sample;
}

}  // namespace

TEST_CASE("row 40: a million equal samples have that value as their mean") {
    PixelAccumulator sums;
    for (int i = 0; i < 1000000; ++i) REQUIRE(sums.add(grey(0.1)));
    const double off = std::fabs(sums.pixel().color.x - 0.1) / 0.1;
    CHECK(off <= 1e-12);
    test::record(40, "mean of a million off by " + test::brief(off) + " of itself");
    CHECK(sums.pixel().samples == 1000000);
}

TEST_CASE("row 40: one firefly costs no more than its own rounding") {
    PixelAccumulator sums;
    long double exact = 0;
    const int n = 100000;
    for (int i = 0; i < n; ++i) {
        const double value = i == 777 ? 1e30 : 0.1;
        REQUIRE(sums.add(grey(value)));
        exact += static_cast<long double>(value);
    }
    const double sum = sums.pixel().color.x * n;
    const double off = std::fabs(sum - static_cast<double>(exact)) / (1e-15 * 1e30 * n);
    CHECK(off <= 1);
    test::record(40, "a firefly's sum off by " + test::brief(off) + " of the bound");
    CHECK(std::isfinite(sum));
}

TEST_CASE("row 40: NaN and infinity are refused whole, and negative zero is no trouble") {
    PixelAccumulator sums;
    CHECK(sums.add(grey(-0.0)));
    CHECK_FALSE(sums.add(grey(std::numeric_limits<double>::quiet_NaN())));
    CHECK_FALSE(sums.add(grey(-std::numeric_limits<double>::infinity())));
    Sample bad_normal = grey(0.5);
    bad_normal.hit = true;
    bad_normal.normal.y = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(sums.add(bad_normal));
    CHECK(sums.add(grey(1)));
    CHECK(sums.pixel().samples == 2);
    CHECK(sums.pixel().color.x == 0.5);
}

TEST_CASE("depth is the mean over the samples that hit, infinity if none did") {
    PixelAccumulator sums;
    CHECK(std::isinf(sums.pixel().depth));
    REQUIRE(sums.add(grey(0)));
    CHECK(std::isinf(sums.pixel().depth));
    for (const double depth : {2.0, 4.0}) {
        Sample sample = grey(0);
        sample.hit = true;
        sample.depth = depth;
        sample.normal = {0, 0, 1};
        REQUIRE(sums.add(sample));
    }
    CHECK(sums.pixel().depth == 3);
    CHECK(sums.pixel().normal.z == doctest::Approx(2.0 / 3));
}

TEST_CASE("planes cover the crop, clamped to the picture") {
    renderer::Settings settings;
    settings.width = 10;
    settings.height = 8;
    settings.crop = renderer::Crop{6, 2, 20, 5};
    settings.want_depth = true;
    renderer::Film film(settings);
    CHECK(film.picture().color.width == 4);
    CHECK(film.picture().color.height == 3);
    CHECK(film.picture().normals.values.empty());
    renderer::Pixel pixel;
    pixel.color = {1e300, -1e300, 0.25};
    film.set_pixel(6, 4, pixel);
    CHECK(film.picture().color.at(0, 2, 0) == std::numeric_limits<float>::max());
    CHECK(film.picture().color.at(0, 2, 2) == 0.25F);
    CHECK(std::isinf(film.picture().depth.at(0, 2, 0)));

    settings.crop = renderer::Crop{50, 0, 60, 5};
    CHECK(renderer::Film(settings).picture().color.values.empty());
}
