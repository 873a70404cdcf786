// SPDX-License-Identifier: MIT
// The noise bill of integrands whose Sobol' indices are known in closed form.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/cost/noise.hpp"
#include "renderer/sampling/hash.hpp"

using namespace cobble::renderer;

namespace {

/// Uniform in [-1, 1), of variance 1/3, by source, seed, value and run.
double uniform(std::uint64_t source, std::uint64_t seed, std::uint64_t value, std::uint64_t run) {
    const std::uint64_t bits = combine(combine(combine(source, seed), value), run);
    return static_cast<double>(bits >> 11U) * 0x1p-52 - 1;
}

/// Values of f = a x + b y + c x y + z: x, y and z are three sources. Variances: a^2/3, b^2/3,
/// c^2/9, 1/3.
struct Synthetic {
    double a, b, c;
    std::uint32_t values;
    std::uint64_t run;

    bool operator()(const std::vector<std::uint16_t>& seeds, std::vector<double>& to) const {
        to.clear();
        for (std::uint32_t i = 0; i < values; ++i) {
            const double x = uniform(1, seeds[0], i, run);
            const double y = uniform(2, seeds[1], i, run);
            const double z = uniform(3, seeds[2], i, run);
            to.push_back(a * x + b * y + c * x * y + z);
        }
        return true;
    }
    [[nodiscard]] double variance() const { return (a * a + b * b + 1) / 3 + c * c / 9; }
};

bool holds(const Interval& band, double value) { return band.low <= value && value <= band.high; }

}  // namespace

TEST_CASE("noise shares hold the true Sobol' indices in 95 % of 200 runs") {
    const std::vector<std::string> sources = {"x", "y", "z"};
    std::uint32_t inside = 0;
    std::uint32_t asked = 0;
    for (std::uint64_t run = 0; run < 200; ++run) {
        const Synthetic f{2, 0.5, 1.5, 64, run};
        const NoiseBill bill = measure_noise(sources, 16, f);
        REQUIRE(bill.seeds == 16);
        REQUIRE(bill.shares.size() == 3);
        const double v = f.variance();
        const double first[] = {4 / 3.0 / v, 0.25 / 3 / v, 1 / 3.0 / v};
        const double mixed = 2.25 / 9 / v;
        for (std::size_t i = 0; i < 3; ++i) {
            inside += holds(bill.shares[i].first_band, first[i]) ? 1 : 0;
            inside += holds(bill.shares[i].total_band, first[i] + (i < 2 ? mixed : 0)) ? 1 : 0;
            asked += 2;
        }
        inside += holds(bill.together_band, mixed) ? 1 : 0;
        ++asked;
        double sum = bill.together;
        for (const NoiseShare& share : bill.shares) sum += share.first;
        CHECK(sum == doctest::Approx(1));
    }
    MESSAGE(inside << " of " << asked << " intervals hold the truth");
    // 95 % of 1400, less two deviations (they are not independent: of 200).
    CHECK(inside >= 0.92 * asked);
}

TEST_CASE("one source makes all the noise, alone and with all others") {
    const auto only_first = [](const std::vector<std::uint16_t>& seeds, std::vector<double>& to) {
        to = {uniform(1, seeds[0], 0, 0), uniform(1, seeds[0], 1, 0)};
        return true;
    };
    const NoiseBill bill = measure_noise({"x", "y"}, 8, only_first);
    CHECK(bill.shares[0].first == doctest::Approx(1));
    CHECK(bill.shares[0].total == doctest::Approx(1));
    CHECK(bill.shares[1].first == doctest::Approx(0));
    CHECK(bill.shares[1].total == doctest::Approx(0));
    CHECK(bill.together == doctest::Approx(0));
}

TEST_CASE("no variance, and no answer, make no bill") {
    const auto still = [](const std::vector<std::uint16_t>&, std::vector<double>& to) {
        to = {1, 2, 3};
        return true;
    };
    CHECK(measure_noise({"x"}, 8, still).shares.empty());
    const auto interrupted = [](const std::vector<std::uint16_t>&, std::vector<double>&) {
        return false;
    };
    CHECK(measure_noise({"x"}, 8, interrupted).seeds == 0);
}
