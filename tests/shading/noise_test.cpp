// SPDX-License-Identifier: MIT
#include "renderer/shading/noise.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/support/record.hpp"

using namespace cobble;
using math::Vec3d;
using renderer::perlin_noise;

namespace {

struct Random {
    std::uint64_t state = 1;
    std::uint64_t next() {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return state >> 11U;
    }
    double unit() { return static_cast<double>(next()) * 0x1p-53; }
};

/// The value at lattice point (i, j, k) of the gradient's hash, found by asking the noise itself
/// how it rises there: close to a lattice point the noise is the dot product of the offset with the
/// corner's gradient.
Vec3d gradient_at(double i, double j, double k) {
    const double h = 0x1p-20;
    const auto slope = [&](double x, double y, double z) {
        return (perlin_noise({i + x, j + y, k + z}) - perlin_noise({i - x, j - y, k - z})) /
               (2 * h);
    };
    return {std::round(slope(h, 0, 0)), std::round(slope(0, h, 0)), std::round(slope(0, 0, h))};
}

/// Lattice noise over integer cells, from its definition: corner gradients, their dot products, a
/// quintic blend. `offset` moves the integer cell far out; the fraction stays what it is.
long double lattice_noise(Vec3d cell, Vec3d fraction) {
    const auto fade = [](long double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    long double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const double dx = corner & 1;
        const double dy = (corner >> 1) & 1;
        const double dz = corner >> 2;
        const auto low = [](double c) {
            const auto i = static_cast<std::int64_t>(c);
            return static_cast<double>(((i % 256) + 256) % 256);
        };
        const Vec3d g = gradient_at(low(cell.x + dx), low(cell.y + dy), low(cell.z + dz));
        const long double x = fade(fraction.x);
        const long double y = fade(fraction.y);
        const long double z = fade(fraction.z);
        const long double weight =
            (dx > 0 ? x : 1 - x) * (dy > 0 ? y : 1 - y) * (dz > 0 ? z : 1 - z);
        sum += weight * (static_cast<long double>(g.x) * (fraction.x - dx) +
                         static_cast<long double>(g.y) * (fraction.y - dy) +
                         static_cast<long double>(g.z) * (fraction.z - dz));
    }
    return sum;
}

}  // namespace

TEST_CASE("improved noise has its published values") {
    // The reference implementation's value at this point is widely published.
    CHECK(perlin_noise({3.14, 42, 7}) == doctest::Approx(0.13691995878400012).epsilon(1e-14));
    CHECK(perlin_noise({-3.14, -42, -7}) != doctest::Approx(0.13691995878400012));
}

TEST_CASE("gradients are the twelve edge directions") {
    Random random;
    for (int n = 0; n < 500; ++n) {
        const Vec3d g = gradient_at(static_cast<double>(random.next() % 512) - 256,
                                    static_cast<double>(random.next() % 512) - 256,
                                    static_cast<double>(random.next() % 512) - 256);
        CHECK(std::fabs(g.x) + std::fabs(g.y) + std::fabs(g.z) == 2);
    }
}

TEST_CASE("row 35: noise equals lattice noise over integer cells up to 2^22, negative ones too") {
    Random random;
    double worst = 0;
    for (int n = 0; n < 4000; ++n) {
        const double reach = std::ldexp(1.0, static_cast<int>(random.next() % 23));
        const auto cell = [&] { return std::floor((2 * random.unit() - 1) * reach); };
        const auto fraction = [&] { return std::floor(random.unit() * 1048576) / 1048576; };
        const Vec3d c{cell(), cell(), cell()};
        const Vec3d f{fraction(), fraction(), fraction()};
        const double off =
            std::fabs(static_cast<double>(lattice_noise(c, f)) - perlin_noise(c + f));
        CHECK(off <= 1e-5);
        worst = std::max(worst, off);
    }
    test::record(35, "off lattice noise by " + test::brief(worst) + " at most");
}

TEST_CASE("row 35: noise wraps at 256 exactly, wherever the sum is exact") {
    Random random;
    for (int n = 0; n < 1000; ++n) {
        const auto coordinate = [&] {
            return std::floor(random.unit() * 256 * 1024) / 1024;  // 18 bits
        };
        const Vec3d p{coordinate(), coordinate(), coordinate()};
        const double shift = 256.0 * static_cast<double>(random.next() % (1U << 30U));
        CHECK(perlin_noise(p + Vec3d{shift, -shift, shift}) == perlin_noise(p));
    }
}

TEST_CASE("row 35: noise is defined everywhere") {
    for (const double x : {1e9, -1e9, 1e15, 0x1p53, -0x1p60, 1e300, 0.0, -0.0, 5e-324, -5e-324}) {
        const double value = perlin_noise({x, 0.5, x});
        CHECK(std::isfinite(value));
        CHECK(std::fabs(value) <= 1.5);
    }
    CHECK(perlin_noise({0x1p60, 0x1p61, -0x1p70}) == 0);
    CHECK(perlin_noise({std::numeric_limits<double>::infinity(), 0, 0}) == 0);
    CHECK(perlin_noise({std::numeric_limits<double>::quiet_NaN(), 0, 0}) == 0);
    CHECK(perlin_noise({7, -300, 12}) == 0);
}

TEST_CASE("row 35: octaves neither overflow nor cost more than they give") {
    CHECK(renderer::octave_noise({0.3, 0.4, 0.5}, 0) == 0);
    CHECK(renderer::octave_noise({0.3, 0.4, 0.5}, 1) == perlin_noise({0.3, 0.4, 0.5}));
    CHECK(renderer::octave_noise({0.3, 0.4, 0.5}, 2) ==
          perlin_noise({0.3, 0.4, 0.5}) + perlin_noise({0.6, 0.8, 1.0}) / 2);
    const double many = renderer::octave_noise({0.3, 0.4, 0.5}, 53);
    CHECK(renderer::octave_noise({0.3, 0.4, 0.5}, 4000000000U) == many);
    CHECK(std::isfinite(renderer::octave_noise({1e300, -1e300, 1e300}, 4000000000U)));
}

TEST_CASE("marble runs from one colour to the other") {
    ir::Noise noise;
    noise.color1 = {1, 0.5, 0};
    noise.color2 = {0, 0.5, 1};
    noise.amplitude = 0;
    CHECK(renderer::marble(noise, {0, 1, 2}) == 0.5);
    CHECK(renderer::marble(noise, {1.5707963267948966, 0, 0}) == 1);
    CHECK(renderer::marble_color(noise, {1.5707963267948966, 0, 0}) == ir::Color{1, 0.5, 0});
    noise.frequency = 1e308;
    CHECK(std::isfinite(renderer::marble(noise, {1e10, 0.5, 0.5})));
}
