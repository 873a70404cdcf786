// SPDX-License-Identifier: MIT
// Own sine to power against double-double (row 44 of the hard cases): at most 2 ulp.
#include "ir/math/elementary.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "tests/oracle/random.hpp"
#include "tests/oracle/reference_functions.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

using oracle::Dd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// |got - expected| in units of the last place of the expected value.
double ulps(double got, Dd expected) {
    if (expected.hi == 0) return got == 0 ? 0 : kInfinity;
    int e = 0;
    std::frexp(expected.hi, &e);
    const double unit = std::ldexp(1.0, e - 53 < -1074 ? -1074 : e - 53);
    return std::fabs(((Dd(got) - expected).hi) / unit);
}

struct Worst {
    double ulps = 0;
    double x = 0, y = 0;
    void see(double u, double at, double and_at = 0) {
        if (!(u <= ulps)) {
            ulps = u;
            x = at;
            y = and_at;
        }
    }
    std::string text() const {
        char buffer[120];
        std::snprintf(buffer, sizeof buffer, "%.3f ulp at %a, %a", ulps, x, y);
        return buffer;
    }
};

#define CHECK_WORST(name, worst)                             \
    do {                                                     \
        CAPTURE((worst).text());                             \
        CHECK((worst).ulps <= 2.0);                          \
        CHECK((worst).ulps > 0.4999);                        \
        record(44, name " " + brief((worst).ulps) + " ulp"); \
    } while (false)

double any_finite(Random& random) {
    for (;;) {
        const double x = std::bit_cast<double>(random.bits());
        if (std::fabs(x) <= std::numeric_limits<double>::max()) return x;
    }
}

}  // namespace

TEST_CASE("row 44: sine, cosine and tangent of small arguments") {
    Random random(1);
    Worst s;
    Worst c;
    Worst t;
    for (int i = 0; i < 600000; ++i) {
        const double x = random.in(-0.78, 0.78) * (i % 3 == 0 ? std::ldexp(1.0, -(i % 60)) : 1);
        const auto expected = oracle::sincos(x);
        s.see(ulps(math::sin(x), expected.sin), x);
        c.see(ulps(math::cos(x), expected.cos), x);
        if (i % 4 == 0) t.see(ulps(math::tan(x), expected.sin / expected.cos), x);
    }
    CHECK_WORST("sine of small arguments", s);
    CHECK_WORST("cosine of small arguments", c);
    CHECK_WORST("tangent of small arguments", t);
}

TEST_CASE("row 44: sine, cosine and tangent of any argument, multiples of pi/2 included") {
    Random random(2);
    Worst s;
    Worst c;
    Worst t;
    for (int i = 0; i < 1500; ++i) {
        double x = random.in(-100, 100);
        if (i % 5 == 1) x = any_finite(random);
        if (i % 5 == 2) x = std::floor(random.in(-1e6, 1e6)) * 1.5707963267948966;
        if (i % 5 == 3) x = std::floor(random.in(-1e15, 1e15)) * 1.5707963267948966;
        if (i % 5 == 4) x = random.in(-1, 1) * 0x1p21;
        // The double that comes closest to a multiple of pi/2 (Kahan and McDonald).
        if (i == 0) x = std::ldexp(6381956970095103.0, 797);
        const auto expected = oracle::sincos(x);
        s.see(ulps(math::sin(x), expected.sin), x);
        c.see(ulps(math::cos(x), expected.cos), x);
        t.see(ulps(math::tan(x), expected.sin / expected.cos), x);
        CHECK(math::sincos(x).sin == math::sin(x));
        CHECK(math::sincos(x).cos == math::cos(x));
    }
    CHECK_WORST("sine of any argument", s);
    CHECK_WORST("cosine of any argument", c);
    CHECK_WORST("tangent of any argument", t);
}

TEST_CASE("row 44: degrees are exact at quarter turns and near their values elsewhere") {
    for (int quarter = -1000; quarter <= 1000; ++quarter) {
        const int q = ((quarter % 4) + 4) % 4;
        const math::SinCos a = math::sincos_degrees(90.0 * quarter);
        const double sines[] = {0, 1, 0, -1};
        CHECK(a.sin == sines[q]);
        CHECK(a.cos == sines[(q + 1) % 4]);
        CHECK(!std::signbit(a.sin == 0 ? a.sin : a.cos));
    }
    CHECK(math::sincos_degrees(360 * 0x1p900).cos ==
          math::sincos_degrees(std::fmod(360 * 0x1p900, 360)).cos);
    constexpr Dd kDegree{0x1.1df46a2529d39p-6, 0x1.5c1d8becdd291p-62};
    Random random(3);
    Worst s;
    Worst c;
    for (int i = 0; i < 100000; ++i) {
        const double x = random.in(-45, 45) * (i % 2 == 0 ? std::ldexp(1.0, -(i % 50)) : 1);
        const int turns = static_cast<int>(random.below(9)) - 4;
        const auto expected = oracle::sincos_small(Dd(x) * kDegree);
        const math::SinCos a = math::sincos_degrees(x);
        s.see(ulps(a.sin, expected.sin), x);
        c.see(ulps(a.cos, expected.cos), x);
        // A whole turn more changes only what the sum with 360 rounds away.
        const double more = x + 360.0 * turns;
        const math::SinCos b = math::sincos_degrees(more);
        const math::SinCos d = math::sincos_degrees(more - 360.0 * turns);
        CHECK(b.sin == d.sin);
        CHECK(b.cos == d.cos);
    }
    CHECK_WORST("sine of degrees", s);
    CHECK_WORST("cosine of degrees", c);
}

TEST_CASE("row 44: arc cosine") {
    Random random(4);
    Worst worst;
    for (int i = 0; i < 200000; ++i) {
        double x = random.in(-1, 1);
        if (i % 3 == 1) x = 1 - std::ldexp(random.unit(), -(i % 52));
        if (i % 3 == 2) x = std::ldexp(random.in(-1, 1), -(i % 90));
        const Dd rest = Dd(1) - math::two_product(x, x);
        const Dd height = sqrt(rest);
        worst.see(ulps(math::acos(x), oracle::angle(height, Dd(x))), x);
    }
    CHECK_WORST("arc cosine", worst);
    CHECK(math::acos(1) == 0);
    CHECK(math::acos(-1) == math::kPi);
    CHECK(math::acos(0) == math::kPi / 2);
    CHECK(std::isnan(math::acos(std::nextafter(1.0, 2.0))));
    CHECK(std::isnan(math::acos(kNan)));
}

TEST_CASE("row 44: the angle of a point") {
    Random random(5);
    Worst worst;
    for (int i = 0; i < 200000; ++i) {
        const double x = random.in(-1, 1);
        const double y = random.in(-1, 1) * (i % 2 == 0 ? 1 : std::ldexp(1.0, (i % 140) - 70));
        worst.see(ulps(math::atan2(y, x), oracle::angle(Dd(y), Dd(x))), y, x);
        // A common power of two changes nothing.
        const int shift = static_cast<int>(random.below(1600)) - 800;
        CHECK(math::atan2(std::ldexp(y, shift), std::ldexp(x, shift)) == math::atan2(y, x));
    }
    CHECK_WORST("angle", worst);
    // The C library's table (C17, F.10.1.4).
    const double values[] = {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity};
    for (const double y : values) {
        for (const double x : values) {
            const double expected = std::atan2(y, x);
            CHECK(math::atan2(y, x) == expected);
            CHECK(std::signbit(math::atan2(y, x)) == std::signbit(expected));
        }
        CHECK(std::isnan(math::atan2(y, kNan)));
        CHECK(std::isnan(math::atan2(kNan, y)));
    }
    constexpr double kLeast = std::numeric_limits<double>::denorm_min();
    CHECK(math::atan2(kLeast, 1.0) == kLeast);
    CHECK(math::atan2(kLeast, kLeast) == math::kPi / 4);
    CHECK(math::atan2(1e308, -1e308) == std::atan2(1.0, -1.0));
}

TEST_CASE("row 44: exponential") {
    Random random(6);
    Worst worst;
    for (int i = 0; i < 300000; ++i) {
        double x = random.in(-708, 709.7);
        if (i % 3 == 1) x = random.in(-1, 1);
        if (i % 3 == 2) x = std::ldexp(random.in(-1, 1), -(i % 60));
        const auto e = oracle::exp_scaled(Dd(x));
        // Compared around 1, where no unit is subnormal.
        worst.see(ulps(std::ldexp(math::exp(x), -e.exponent), e.value), x);
    }
    CHECK_WORST("exponential", worst);
    CHECK(math::exp(0) == 1);
    CHECK(math::exp(-0.0) == 1);
    CHECK(math::exp(kInfinity) == kInfinity);
    CHECK(math::exp(-kInfinity) == 0);
    CHECK(math::exp(710) == kInfinity);
    CHECK(math::exp(-746) == 0);
    CHECK(math::exp(-745) == std::numeric_limits<double>::denorm_min());
    CHECK(std::isnan(math::exp(kNan)));
}

TEST_CASE("row 44: logarithm") {
    Random random(7);
    Worst worst;
    for (int i = 0; i < 100000; ++i) {
        double x = std::fabs(any_finite(random));
        if (i % 3 == 1) x = random.in(0.5, 2);
        if (i % 3 == 2) x = 1 + std::ldexp(random.in(-1, 1), -(i % 52));
        if (x == 0) continue;
        worst.see(ulps(math::log(x), oracle::log(x)), x);
    }
    CHECK_WORST("logarithm", worst);
    CHECK(math::log(1) == 0);
    CHECK(math::log(0) == -kInfinity);
    CHECK(math::log(-0.0) == -kInfinity);
    CHECK(math::log(kInfinity) == kInfinity);
    CHECK(std::isnan(math::log(-1)));
    CHECK(std::isnan(math::log(kNan)));
    CHECK(math::log(std::numeric_limits<double>::denorm_min()) == std::log(0x1p-1074));
}

TEST_CASE("row 44: power") {
    Random random(8);
    Worst worst;
    for (int i = 0; i < 100000; ++i) {
        double x = random.unit();
        if (i % 4 == 1) x = std::fabs(any_finite(random));
        if (i % 4 == 2) x = 1 + std::ldexp(random.in(-1, 1), -(i % 40));
        if (x == 0 || x == 1) continue;
        const Dd l = oracle::log(x);
        const double y = random.in(-700, 700) / l.hi;
        if (!(std::fabs(y) <= 1e300) || std::fabs(y) < 1e-300) continue;
        const auto e = oracle::exp_scaled(l * Dd(y));
        worst.see(ulps(std::ldexp(math::pow(x, y), -e.exponent), e.value), x, y);
    }
    CHECK_WORST("power", worst);
    // The C library's table (C17, F.10.4.4), by comparison.
    const double values[] = {0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             2.0,
                             -2.0,
                             0.5,
                             -0.5,
                             3.0,
                             -3.0,
                             2.5,
                             kInfinity,
                             -kInfinity,
                             kNan,
                             1e300,
                             -1e300,
                             9007199254740993.0};
    for (const double x : values) {
        for (const double y : values) {
            const double expected = std::pow(x, y);
            const double got = math::pow(x, y);
            CAPTURE(x);
            CAPTURE(y);
            CHECK(std::isnan(got) == std::isnan(expected));
            if (!std::isnan(expected)) {
                CHECK((got == expected || ulps(got, Dd(expected)) <= 1));
                CHECK(std::signbit(got) == std::signbit(expected));
            }
        }
    }
}

TEST_CASE("infinite and undefined angles give no number") {
    for (const double x : {kInfinity, -kInfinity, kNan}) {
        CHECK(std::isnan(math::sin(x)));
        CHECK(std::isnan(math::cos(x)));
        CHECK(std::isnan(math::tan(x)));
        CHECK(std::isnan(math::sincos(x).sin));
        CHECK(std::isnan(math::sincos_degrees(x).cos));
    }
    CHECK(std::signbit(math::sin(-0.0)));
    CHECK(std::signbit(math::tan(-0.0)));
}

}  // namespace cobble::test
