// SPDX-License-Identifier: MIT
// The statistics that stopping rules and reports are made of, against tables and brute force.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "ir/math/elementary.hpp"
#include "renderer/estimate/bernstein.hpp"
#include "renderer/estimate/jackknife.hpp"
#include "renderer/estimate/pixel_error.hpp"
#include "renderer/estimate/student.hpp"
#include "renderer/film/scramble_sums.hpp"
#include "renderer/passes/looks.hpp"
#include "renderer/sampling/hash.hpp"

using namespace cobble;
using namespace cobble::renderer;

namespace {

/// Uniform in [0, 1).
double uniform(std::uint64_t a, std::uint64_t b) {
    return static_cast<double>(combine(a, b) >> 11U) * 0x1p-53;
}
/// Of a normal distribution (Box and Muller, 1958).
double normal(std::uint64_t a, std::uint64_t b) {
    const double radius = std::sqrt(-2 * math::log(1 - uniform(a, 2 * b)));
    return radius * math::cos(2 * math::kPi * uniform(a, 2 * b + 1));
}

}  // namespace

TEST_CASE("Student's t is that of the tables") {
    // Two-sided quantiles as printed in tables of the distribution (NIST/SEMATECH e-Handbook of
    // Statistical Methods, 1.3.6.7.2), to their three decimals.
    const struct {
        std::uint32_t degrees;
        double five, one;  // per cent in both tails
    } rows[] = {{1, 12.706, 63.657}, {2, 4.303, 9.925},  {3, 3.182, 5.841},  {4, 2.776, 4.604},
                {5, 2.571, 4.032},   {7, 2.365, 3.499},  {10, 2.228, 3.169}, {15, 2.131, 2.947},
                {30, 2.042, 2.750},  {100, 1.984, 2.626}};
    for (const auto& row : rows) {
        CAPTURE(row.degrees);
        CHECK(student_quantile(0.05, row.degrees) == doctest::Approx(row.five).epsilon(3e-4));
        CHECK(student_quantile(0.01, row.degrees) == doctest::Approx(row.one).epsilon(3e-4));
    }
    for (std::uint32_t degrees = 1; degrees < 40; ++degrees) {
        CHECK(student_probability(0, degrees) == 0);
        for (const double tails : {0.5, 0.05, 0.001, 1e-6}) {
            const double t = student_quantile(tails, degrees);
            CHECK(1 - student_probability(t, degrees) == doctest::Approx(tails).epsilon(1e-6));
        }
    }
}

TEST_CASE("all looks together miss less often than they may") {
    double sum = 0;
    for (std::uint32_t look = 1; look <= kMostLooks; ++look) {
        CHECK(miss_probability(look) > 0);
        sum += miss_probability(look);
    }
    CHECK(sum < kMissProbability);
    CHECK(sum > 0.95 * kMissProbability);
}

TEST_CASE("a pixel's variance is that of its mean, without bias") {
    // Pixels of which the truth is known: 8 scrambles of 4 normal numbers, mean 0.5, deviation 0.2.
    constexpr std::uint32_t kPixels = 4000, kOf = 8, kSamples = 4;
    ScrambleSums sums(kPixels, kOf, {});
    for (std::uint32_t i = 0; i < kPixels; ++i) {
        for (std::uint32_t k = 0; k < kOf; ++k) {
            math::Vec3d mean;
            for (std::uint32_t s = 0; s < kSamples; ++s) {
                const std::uint64_t number = (std::uint64_t{i} * kOf + k) * kSamples + s;
                for (std::size_t c = 0; c < 3; ++c) {
                    mean[c] += (0.5 + 0.2 * normal(7 + c, number)) / kSamples;
                }
            }
            sums.add_color(i, k, mean, kSamples);
        }
    }
    const double t = student_quantile(0.05, kOf - 1);
    double variance = 0;
    std::uint32_t inside = 0;
    for (std::uint32_t i = 0; i < kPixels; ++i) {
        const PixelEstimate pixel = estimate_pixel(sums, i);
        CHECK(pixel.samples == kOf * kSamples);
        variance += pixel.variance.x / kPixels;
        if (std::fabs(pixel.mean.x - 0.5) <= t * std::sqrt(pixel.variance.x)) ++inside;
    }
    // 0.2^2 / 32; the estimate's own deviation is 0.8 % of it.
    CHECK(variance == doctest::Approx(0.00125).epsilon(0.03));
    // 95 %, with a deviation of 0.34 %.
    CHECK(inside > 0.938 * kPixels);
    CHECK(inside < 0.962 * kPixels);
}

TEST_CASE("what a display clamps is no error of the picture") {
    CHECK(displayed_reach(0.5, 0.1, false) == doctest::Approx(0.1));
    CHECK(displayed_reach(5, 1, false) == 0);
    CHECK(displayed_reach(-2, 1, false) == 0);
    CHECK(displayed_reach(1, 0.1, false) == doctest::Approx(0.1));
    // The picture shows the mean, however near to an end it is.
    CHECK(displayed_reach(0.98, 0.05, false) == doctest::Approx(0.05));
    CHECK(displayed_reach(0.004, 0.0116, false) == doctest::Approx(0.0116));
    // In light, dark values are spread on the display: sRGB's slope at 0 is 12.92.
    CHECK(displayed_reach(0.001, 0.001, true) == doctest::Approx(0.01292));
}

TEST_CASE("the empirical Bernstein bound holds, and is what its authors say") {
    // sqrt(2 v ln(4 / d) / n) + 7 ln(4 / d) / (3 (n - 1)) by hand for v = 0.25, n = 101, d = 0.04.
    const double surprise = std::log(100.0);
    CHECK(bernstein_half_width(0.25, 101, 0.04) ==
          doctest::Approx(std::sqrt(0.5 * surprise / 101) + 7 * surprise / 300).epsilon(1e-12));
    CHECK(bernstein_half_width(0, bernstein_fewest(0.01, 0.05), 0.05) <= 0.01);
    CHECK(bernstein_half_width(0, bernstein_fewest(0.01, 0.05) / 2, 0.05) > 0.01);
    // Of rare events, where intervals by the central limit theorem fail: 1 in 200.
    constexpr std::uint32_t kNumbers = 512, kTries = 2000;
    std::uint32_t missed = 0;
    std::uint32_t missed_by_student = 0;
    for (std::uint32_t i = 0; i < kTries; ++i) {
        double ones = 0;
        for (std::uint32_t j = 0; j < kNumbers; ++j) ones += uniform(i, j) < 0.005 ? 1 : 0;
        const double mean = ones / kNumbers;
        const double variance = mean * (1 - mean) * kNumbers / (kNumbers - 1.0);
        if (std::fabs(mean - 0.005) > bernstein_half_width(variance, kNumbers, 0.05)) ++missed;
        const double reach = student_quantile(0.05, kNumbers - 1) * std::sqrt(variance / kNumbers);
        if (std::fabs(mean - 0.005) > reach) ++missed_by_student;
    }
    CHECK(missed <= 0.05 * kTries);
    CHECK(missed_by_student > 0.05 * kTries);
}

TEST_CASE("the jackknife of a mean is Student's interval of it") {
    std::vector<double> numbers;
    for (std::uint32_t i = 0; i < 9; ++i) numbers.push_back(normal(3, i));
    double sum = 0;
    for (const double x : numbers) sum += x;
    std::vector<double> left_out;
    double squares = 0;
    for (const double x : numbers) {
        left_out.push_back((sum - x) / 8);
        squares += (x - sum / 9) * (x - sum / 9);
    }
    CHECK(jackknife_reach(left_out) ==
          doctest::Approx(student_quantile(0.05, 8) * std::sqrt(squares / 8 / 9)).epsilon(1e-9));
}
