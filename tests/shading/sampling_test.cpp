// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <vector>

#include "renderer/sampling/mappings.hpp"
#include "renderer/sampling/sampler.hpp"

using namespace cobble;
using renderer::Draw;
using renderer::PathAddress;
using renderer::Sampler;
using renderer::Uniform2;

TEST_CASE("the unscrambled second dimension is Sobol's") {
    // Radical inverses of the first points, as published: 0 1/2 1/4 3/4 5/8 1/8 3/8 7/8.
    const std::vector<double> expected = {0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875};
    for (std::uint32_t i = 0; i < 8; ++i) {
        CHECK(renderer::sobol_second(i) * 0x1p-32 == expected[i]);
    }
}

TEST_CASE("every power-of-two set is stratified in all elementary intervals") {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        for (unsigned m = 1; m <= 8; ++m) {
            const std::uint32_t n = 1U << m;
            // Also a later stretch: indices k n to (k + 1) n.
            const std::uint32_t first = n * static_cast<std::uint32_t>(seed % 5);
            for (unsigned x_bits = 0; x_bits <= m; ++x_bits) {
                std::set<std::pair<double, double>> cells;
                for (std::uint32_t i = 0; i < n; ++i) {
                    const Uniform2 u = renderer::sobol_point(first + i, renderer::mix64(seed + 99));
                    REQUIRE(u.x >= 0);
                    REQUIRE(u.x < 1);
                    cells.insert({std::floor(std::ldexp(u.x, static_cast<int>(x_bits))),
                                  std::floor(std::ldexp(u.y, static_cast<int>(m - x_bits)))});
                }
                CHECK(cells.size() == n);
            }
        }
    }
}

TEST_CASE("sets of different keys are unrelated") {
    // Correlation of two uniform sets of n points is about 1 / sqrt(n); of one with itself it is 1.
    const int n = 4096;
    const auto correlation = [&](auto&& a, auto&& b) {
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += (a(i) - 0.5) * (b(i) - 0.5);
        return 12 * sum / n;
    };
    const auto draw = [](std::uint64_t seed, std::uint32_t x, std::uint32_t y, Draw what,
                         PathAddress path, std::uint32_t light) {
        return [=](int i) {
            // Over pixels at a fixed sample, where a weak hash would show.
            const auto step = static_cast<std::uint32_t>(i);
            return Sampler(seed, x + step % 64, y + step / 64, 3).draw(what, path, light).x;
        };
    };
    const PathAddress root;
    const auto base = draw(1, 0, 0, Draw::kLight, root, 0);
    const double limit = 5 / std::sqrt(n);
    CHECK(correlation(base, base) > 0.9);
    CHECK(std::fabs(correlation(base, draw(2, 0, 0, Draw::kLight, root, 0))) < limit);
    CHECK(std::fabs(correlation(base, draw(1, 1, 0, Draw::kLight, root, 0))) < limit);
    CHECK(std::fabs(correlation(base, draw(1, 0, 1, Draw::kLight, root, 0))) < limit);
    CHECK(std::fabs(correlation(base, draw(1, 0, 0, Draw::kLens, root, 0))) < limit);
    CHECK(std::fabs(correlation(base, draw(1, 0, 0, Draw::kLight, root, 1))) < limit);
    CHECK(std::fabs(correlation(base, draw(1, 0, 0, Draw::kLight, root.reflected(), 0))) < limit);
    CHECK(std::fabs(correlation(base, draw(1, 0, 0, Draw::kLight, root.refracted(), 0))) < limit);
}

TEST_CASE("path addresses are the strings of turns, all different, however deep") {
    CHECK(PathAddress{}.value() == 1);
    CHECK(PathAddress{}.reflected().refracted().refracted().value() == 0b1011);
    std::set<std::uint64_t> seen;
    PathAddress mirror;
    PathAddress glass;
    for (int depth = 0; depth < 1000; ++depth) {
        mirror = mirror.reflected();
        glass = glass.refracted();
        CHECK(seen.insert(mirror.value()).second);
        CHECK(seen.insert(glass.value()).second);
    }
}

namespace {

struct Moments {
    math::Vec2d mean, square;
    double largest = 0;
};

template <typename F>
Moments moments(F&& sample, std::uint32_t n = 1U << 16U) {
    Moments m;
    for (std::uint32_t i = 0; i < n; ++i) {
        const math::Vec2d p = sample(renderer::sobol_point(i, 42));
        m.mean.x += p.x / n;
        m.mean.y += p.y / n;
        m.square.x += p.x * p.x / n;
        m.square.y += p.y * p.y / n;
        m.largest = std::fmax(m.largest, std::hypot(p.x, p.y));
    }
    return m;
}

}  // namespace

TEST_CASE("the disk is uniform") {
    const Moments m = moments(renderer::sample_disk);
    CHECK(std::fabs(m.mean.x) < 1e-3);
    CHECK(std::fabs(m.mean.y) < 1e-3);
    CHECK(m.square.x == doctest::Approx(0.25).epsilon(2e-3));  // r^2 / 4
    CHECK(m.square.y == doctest::Approx(0.25).epsilon(2e-3));
    CHECK(m.largest <= 1 + 1e-15);
    CHECK(m.largest > 0.999);
    CHECK(renderer::sample_disk({0.5, 0.5}) == math::Vec2d{0, 0});
}

TEST_CASE("polygons are uniform and keep inside their corners") {
    for (std::uint32_t sides = 3; sides <= 16; ++sides) {
        const Moments m = moments([&](Uniform2 u) { return renderer::sample_polygon(u, sides); });
        // Second moment of a regular polygon about its centre, circumradius 1, one axis:
        // (2 + cos(2 pi / n)) / 12.
        const double expected = (2 + std::cos(2 * 3.141592653589793 / sides)) / 12;
        CHECK(std::fabs(m.mean.x) < 2e-3);
        CHECK(std::fabs(m.mean.y) < 2e-3);
        CHECK(m.square.x == doctest::Approx(expected).epsilon(5e-3));
        CHECK(m.square.y == doctest::Approx(expected).epsilon(5e-3));
        CHECK(m.largest <= 1 + 1e-12);
        double lowest = 1;
        for (std::uint32_t i = 0; i < 4096; ++i) {
            const math::Vec2d p = renderer::sample_polygon(renderer::sobol_point(i, 7), sides);
            lowest = std::fmin(lowest, p.y);
        }
        // A corner on top: an odd polygon has an edge at the bottom, at -cos(pi / n).
        if (sides % 2 == 1) CHECK(lowest >= -std::cos(3.141592653589793 / sides) - 1e-12);
    }
}

TEST_CASE("the cone is uniform in solid angle, and exact when closed") {
    for (std::uint32_t i = 0; i < 64; ++i) {
        CHECK(renderer::sample_cone(renderer::sobol_point(i, 5), 0) == math::Vec3d{0, 0, 1});
    }
    const double half = 0.3;
    double mean = 0;
    const std::uint32_t n = 1U << 14U;
    for (std::uint32_t i = 0; i < n; ++i) {
        const math::Vec3d d =
            renderer::sample_cone(renderer::sobol_point(i, 5), 1 - std::cos(half));
        CHECK(std::fabs(math::length(d) - 1) < 1e-15 * 4);
        CHECK(d.z >= std::cos(half) - 1e-15);
        mean += d.z / n;
    }
    CHECK(mean == doctest::Approx((1 + std::cos(half)) / 2).epsilon(1e-5));
}

TEST_CASE("filters have their shapes") {
    const auto of = [](renderer::PixelFilter filter) {
        return moments([=](Uniform2 u) { return renderer::sample_filter(u, filter); });
    };
    CHECK(of(renderer::PixelFilter::kBox).square.x == doctest::Approx(1.0 / 12).epsilon(1e-3));
    CHECK(of(renderer::PixelFilter::kTent).square.x == doctest::Approx(1.0 / 6).epsilon(1e-3));
    CHECK(of(renderer::PixelFilter::kTent).largest <= std::sqrt(2.0));
    const Moments gaussian = of(renderer::PixelFilter::kGaussian);
    // Variance of the cut Gaussian: s^2 (1 - a e^-a / (1 - e^-a)), a = 4.5 the cut in r^2 / (2
    // s^2).
    const double tail = std::exp(-4.5);
    CHECK(gaussian.square.x == doctest::Approx(0.25 * (1 - 4.5 * tail / (1 - tail))).epsilon(2e-3));
    CHECK(gaussian.largest <= 1.5);
    CHECK(std::fabs(gaussian.mean.x) < 1e-3);
}
