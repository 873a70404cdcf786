// SPDX-License-Identifier: MIT
// How errors fall with the number of samples, on scenes whose pictures are known in closed form.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "ir/math/elementary.hpp"
#include "renderer/cost/curve.hpp"
#include "renderer/sampling/sampler.hpp"
#include "tests/render/scene_builder.hpp"

using namespace cobble;
using namespace cobble::test;

namespace {

constexpr double kDistance = 2;
constexpr double kRadius = 1.5;

/// A floor under a round light of kRadius at kDistance, seen in one point: nothing is hidden.
ir::Scene lit_floor() {
    SceneBuilder b;
    b.camera({0, 1, 0}, {0, -1, 0}, 1e-9);
    b.material({1, 1, 1});
    b.plane({0, 1, 0}, 0);
    b.point_light({0, kDistance, 0}, {1, 1, 1}, kRadius);
    return b.scene();
}
/// The mean cosine over a disk that faces the point: d times the mean of 1 / sqrt(d^2 + r^2).
double lit_floor_truth() {
    const double d = kDistance;
    return d * 2 / (kRadius * kRadius) * (std::sqrt(d * d + kRadius * kRadius) - d);
}

/// One column of so many pixels, all alike: as many independent pictures of one pixel.
constexpr std::uint32_t kPixels = 64;

/// A wall of 1 that covers the left three tenths of each pixel, of side 1.
ir::Scene edge() {
    SceneBuilder b;
    b.camera({0, 0, 10}, {0, 0, -1}, 2 * math::atan2(kPixels / 2.0, 10));
    b.background({0, 0, 0}, {1, 1, 1});
    b.material({1, 1, 1});
    b.triangle({-100, -100, 0}, {-0.2, -100, 0}, {-0.2, 300, 0});
    b.triangle({-100, -100, 0}, {-0.2, 300, 0}, {-100, 300, 0});
    return b.scene();
}

/// Slope of the error of pictures of 4 to 1024 samples against `truth`: 32 seeds each.
double slope_against(const ir::Scene& scene, double truth, bool independent) {
    constexpr std::uint32_t kSeeds = 32;
    double x_sum = 0, y_sum = 0, xx = 0, xy = 0, n = 0;
    for (std::uint32_t samples = 4; samples <= 1024; samples *= 4) {
        double squares = 0;
        for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
            renderer::Settings s = settings(1, kPixels, samples, effects({Effect::kSoftShadows}));
            s.seed = seed;
            // One sample each of as many sets that are independent of each other.
            if (independent) s.scrambles = samples;
            const Rendered picture = render(scene, s);
            for (std::uint32_t y = 0; y < kPixels; ++y) {
                const double off = picture.color(0, y).x - truth;
                squares += off * off / (kSeeds * kPixels);
            }
        }
        const double x = std::log(samples);
        const double y = std::log(squares) / 2;
        n += 1;
        x_sum += x;
        y_sum += y;
        xx += x * x;
        xy += x * y;
    }
    return (n * xy - x_sum * y_sum) / (n * xx - x_sum * x_sum);
}

}  // namespace

TEST_CASE("errors against closed forms fall as the theory says") {
    const double floor_random = slope_against(lit_floor(), lit_floor_truth(), true);
    const double floor_sobol = slope_against(lit_floor(), lit_floor_truth(), false);
    const double edge_random = slope_against(edge(), 0.3, true);
    const double edge_sobol = slope_against(edge(), 0.3, false);
    MESSAGE("lit floor: " << floor_random << " and " << floor_sobol << "; edge: " << edge_random
                          << " and " << edge_sobol);
    CHECK(std::fabs(floor_random + 0.5) < 0.03);
    CHECK(std::fabs(edge_random + 0.5) < 0.03);
    CHECK(floor_sobol <= -0.7);
    CHECK(edge_sobol <= -0.7);
}

TEST_CASE("the curve of a picture has the error and the slope that its scatter has") {
    // Scatters of pictures whose error is exactly 1 / sqrt(samples), by made-up sums.
    std::vector<renderer::Scatters> points;
    for (std::uint32_t samples = 1; samples <= 64; samples *= 2) {
        renderer::ScrambleSums sums(1, 8, {});
        for (std::uint32_t k = 0; k < 8; ++k) {
            // +-d in turn: the unbiased variance is 8/7 d^2.
            const double d = std::sqrt(7.0 / 8 / samples);
            const double value = 0.5 + (k % 2 == 0 ? d : -d);
            sums.add_color(0, k, {value, value, value}, samples);
        }
        points.push_back(renderer::scatter_of(sums, samples, samples));
        CHECK(points.back().mean_square == doctest::Approx(1.0 / samples));
    }
    const renderer::ErrorCurve curve = renderer::make_curve(points);
    REQUIRE(curve.points.size() == 7);
    CHECK(curve.replicates == 8);
    for (const renderer::CurvePoint& point : curve.points) {
        CHECK(point.error == doctest::Approx(1 / std::sqrt(point.samples)));
        CHECK(point.band.low <= point.error);
        CHECK(point.band.high >= point.error);
    }
    CHECK(curve.slope == doctest::Approx(-0.5));
}

TEST_CASE("the band of an error holds the true one in 95 % of curves") {
    // Pixels of independent normal numbers of deviation 1: the true error is 1 / sqrt(samples).
    constexpr std::uint32_t kWidth = 50;
    std::uint32_t inside = 0;
    constexpr std::uint32_t kRuns = 400;
    for (std::uint32_t run = 0; run < kRuns; ++run) {
        renderer::ScrambleSums sums(kWidth, 8, {});
        for (std::uint32_t i = 0; i < kWidth; ++i) {
            for (std::uint32_t k = 0; k < 8; ++k) {
                const std::uint64_t key = renderer::combine(run, 8 * i + k);
                const renderer::Uniform2 u = renderer::random_point(1, key);
                const double radius = std::sqrt(-2 * std::log(1 - u.x));
                const double z = radius * std::cos(2 * math::kPi * u.y);
                sums.add_color(i, k, {z, z, z}, 1);
            }
        }
        const renderer::ErrorCurve curve = renderer::make_curve({renderer::scatter_of(sums, 1, 1)});
        if (curve.points[0].band.low <= 1 && 1 <= curve.points[0].band.high) ++inside;
    }
    MESSAGE(inside << " of " << kRuns << " bands hold the truth");
    CHECK(inside >= 0.92 * kRuns);
    CHECK(inside <= 0.98 * kRuns);
}
