// SPDX-License-Identifier: MIT
#include "renderer/shading/fresnel.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace cobble;
using math::Vec3;
using renderer::Refraction;

namespace {

/// A ray coming down at `sine` of its angle to the normal +y.
template <typename T>
Vec3<T> downwards(double sine) {
    return Vec3<double>{sine, -std::sqrt((1 - sine) * (1 + sine)), 0}.to<T>();
}

template <typename T>
Vec3<T> up() {
    return {T(0), T(1), T(0)};
}

}  // namespace

TEST_CASE_TEMPLATE("Snell's law holds", T, float, double) {
    const double tolerance = sizeof(T) == 4 ? 1e-6 : 1e-14;
    for (const double from : {1.0, 1.33, 1.5, 2.4}) {
        for (const double to : {1.0, 1.33, 1.5, 2.4}) {
            for (double sine = 0; sine < 1; sine += 0.01) {
                const auto d = downwards<T>(sine);
                const auto r = renderer::refract(d, up<T>(), T(from), T(to));
                const double expected =
                    sine * static_cast<double>(T(from)) / static_cast<double>(T(to));
                if (expected > 1 + 1e-6) CHECK(r.total);
                if (expected < 1 - 1e-6) {
                    REQUIRE_FALSE(r.total);
                    CHECK(std::fabs(r.direction.x - expected) <= tolerance * 4);
                    CHECK(std::fabs(math::length(r.direction) - 1) <= tolerance);
                    CHECK(r.direction.y < 0);
                    CHECK(r.reflectance >= 0);
                    CHECK(r.reflectance <= 1);
                }
            }
        }
    }
}

TEST_CASE_TEMPLATE("head-on reflectance is the exact one", T, float, double) {
    const auto r = renderer::refract(downwards<T>(0), up<T>(), T(1), T(1.5));
    CHECK(static_cast<double>(r.reflectance) == doctest::Approx(0.04).epsilon(1e-6));
    const auto back = renderer::refract(downwards<T>(0), up<T>(), T(1.5), T(1));
    CHECK(static_cast<double>(back.reflectance) == doctest::Approx(0.04).epsilon(1e-6));
}

TEST_CASE_TEMPLATE("row 31: around the critical angle nothing jumps and nothing is no number", T,
                   float, double) {
    const T glass = T(1.5);
    T sine = static_cast<T>(1.0 / static_cast<double>(glass));
    for (int k = 0; k < 64; ++k) sine = std::nextafter(sine, T(0));
    T last = -1;
    for (int k = -64; k <= 64; ++k, sine = std::nextafter(sine, T(1))) {
        const auto d = downwards<T>(static_cast<double>(sine));
        const auto r = renderer::refract(d, up<T>(), glass, T(1));
        CHECK_FALSE(std::isnan(r.reflectance));
        CHECK(r.reflectance >= 0);
        CHECK(r.reflectance <= 1);
        // Reflectance goes to 1 as 1 - 5 c with c the cosine outside, about sqrt(2 k ulp).
        const double bound = 5 * std::sqrt(2.0 * 66 * std::numeric_limits<T>::epsilon()) * 1.5;
        CHECK(static_cast<double>(r.reflectance) >= 1 - bound);
        if (!r.total) {
            CHECK(std::isfinite(r.direction.x));
            CHECK(std::fabs(static_cast<double>(r.direction.x) - 1) <= bound * bound + 1e-6);
        }
        if (last >= 0) CHECK(std::fabs(static_cast<double>(r.reflectance - last)) <= bound);
        last = r.reflectance;
    }
}

TEST_CASE_TEMPLATE("row 31: equal indices leave a ray's bits alone", T, float, double) {
    for (double sine = 0; sine < 1; sine += 0.0137) {
        const auto d = downwards<T>(sine);
        const auto r = renderer::refract(d, up<T>(), T(1.33), T(1.33));
        REQUIRE_FALSE(r.total);
        CHECK(r.direction == d);
    }
}

TEST_CASE_TEMPLATE("row 31: extreme indices and grazing rays stay finite", T, float, double) {
    for (const double index : {1e-3, 1e3, 1e-30, 1e30}) {
        for (const double sine : {0.0, 1e-7, 0.5, 1 - 1e-7, 1.0}) {
            for (const auto& r : {renderer::refract(downwards<T>(sine), up<T>(), T(1), T(index)),
                                  renderer::refract(downwards<T>(sine), up<T>(), T(index), T(1))}) {
                CHECK(r.reflectance >= 0);
                CHECK(r.reflectance <= 1);
                if (!r.total) CHECK(std::fabs(math::length(r.direction) - 1) < 1e-6);
            }
        }
    }
}

TEST_CASE_TEMPLATE("row 30: a bent normal sends nothing through the surface", T, float, double) {
    const Vec3<T> ground = up<T>();
    for (double tilt = -1.5; tilt <= 1.5; tilt += 0.05) {
        for (double sine = -0.999; sine < 1; sine += 0.05) {
            const auto d = downwards<T>(sine);
            const auto bent = Vec3<double>{std::sin(tilt), std::cos(tilt), 0}.to<T>();
            const Vec3<T> normal = renderer::facing(bent, ground, d);
            CHECK(std::fabs(math::length(normal) - 1) < 1e-5);
            CHECK(math::dot(normal, d) <= 1e-6);
            const auto mirrored = renderer::keep_above(renderer::reflect(d, normal), ground);
            CHECK(mirrored.y >= 0);
            CHECK(std::fabs(math::length(mirrored) - 1) < 1e-5);
        }
    }
    CHECK(renderer::facing(downwards<T>(0), ground, downwards<T>(0)) == ground);
}
