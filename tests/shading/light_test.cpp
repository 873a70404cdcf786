// SPDX-License-Identifier: MIT
#include "renderer/shading/light.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "renderer/shading/frame.hpp"
#include "renderer/shading/phong.hpp"

using namespace cobble;
using math::Vec3;
using math::Vec3d;

namespace {

ir::Light point_light(Vec3d position, double falloff, double radius) {
    ir::Light light;
    light.position = position;
    light.color = {0.9, 0.6, 0.3};
    light.falloff = falloff;
    light.radius = radius;
    return light;
}

ir::Light sun(Vec3d direction, double angle) {
    ir::Light light;
    light.kind = ir::Light::Kind::kDirectional;
    light.direction = math::normalize(direction);
    light.color = {1, 1, 1};
    light.angle = angle;
    return light;
}

}  // namespace

TEST_CASE("intensity falls off as the language says") {
    const auto light = renderer::prepare_light(point_light({0, 3, 0}, 0.5, 0), {});
    const auto sample = renderer::light_middle<double>(light, {0, 1, 0});
    CHECK(sample.intensity.x == doctest::Approx(0.9 / (1 + 0.5 * 4)));
    CHECK(sample.direction == Vec3d{0, 1, 0});
    CHECK(sample.target == Vec3d{0, 3, 0});
    // Without falloff the colour's bits.
    const auto plain = renderer::prepare_light(point_light({0, 3, 0}, 0, 0), {});
    CHECK(renderer::light_middle<double>(plain, {5, 1, 2}).intensity == Vec3d{0.9, 0.6, 0.3});
}

TEST_CASE_TEMPLATE("a light without size has the bits of its middle, wherever it is sampled", T,
                   float, double) {
    const Vec3d origin{1, -2, 3};
    for (const auto& light : {renderer::prepare_light(point_light({0.1, 3, -7}, 0.3, 0), origin),
                              renderer::prepare_light(sun({0.3, -1, 0.2}, 0), origin),
                              renderer::prepare_light(sun({0, 0, 1}, 0), origin)}) {
        for (std::uint32_t i = 0; i < 256; ++i) {
            const Vec3<T> at{T(i) / 7, T(1), T(-0.3)};
            const auto middle = renderer::light_middle<T>(light, at);
            const auto sample = renderer::light_sample<T>(light, at, renderer::sobol_point(i, 3));
            CHECK(sample.direction == middle.direction);
            CHECK(sample.intensity == middle.intensity);
            CHECK(sample.target == middle.target);
        }
    }
}

TEST_CASE("a point light with a radius is a disk that faces the surface") {
    const auto light = renderer::prepare_light(point_light({0, 4, 0}, 0, 0.5), {});
    double largest = 0;
    for (std::uint32_t i = 0; i < 4096; ++i) {
        const auto s =
            renderer::light_sample<double>(light, {0, 1, 0}, renderer::sobol_point(i, 3));
        CHECK(s.target.y == doctest::Approx(4));
        largest = std::fmax(largest, std::hypot(s.target.x, s.target.z));
    }
    CHECK(largest <= 0.5 + 1e-12);
    CHECK(largest > 0.495);
}

TEST_CASE("a sun's directions lie within half its diameter") {
    const double diameter = 0.2;
    const auto light = renderer::prepare_light(sun({1, -2, 0.5}, diameter), {});
    double least = 1;
    for (std::uint32_t i = 0; i < 4096; ++i) {
        const auto s = renderer::light_sample<double>(light, {}, renderer::sobol_point(i, 3));
        CHECK(std::fabs(math::length(s.direction) - 1) < 1e-14);
        least = std::fmin(least, math::dot(s.direction, light.toward));
    }
    CHECK(least >= std::cos(diameter / 2) - 1e-12);
    CHECK(least <= std::cos(diameter / 2 * 0.98));
}

TEST_CASE_TEMPLATE("row 39: a light on the very point gives nothing, and no NaN", T, float,
                   double) {
    for (const double radius : {0.0, 0.5}) {
        const auto light = renderer::prepare_light(point_light({1, 2, 3}, 2, radius), {});
        const Vec3<T> at{1, 2, 3};
        for (const auto& s : {renderer::light_middle<T>(light, at),
                              renderer::light_sample<T>(light, at, {0.5, 0.5}),
                              renderer::light_sample<T>(light, at, {0.1, 0.8})}) {
            const auto color = renderer::phong<T>({0, 1, 0}, s.direction, {0, 1, 0}, {1, 1, 1},
                                                  {1, 1, 1}, 20, true);
            CHECK(std::isfinite(color.x));
            CHECK(std::isfinite(s.intensity.x));
        }
        CHECK(renderer::light_middle<T>(light, at).direction == Vec3<T>{});
    }
}

TEST_CASE("Phong has a highlight only where light falls and shininess asks for it") {
    const Vec3d n{0, 1, 0};
    const Vec3d kd{0.5, 0.25, 0};
    const Vec3d ks{1, 1, 1};
    const Vec3d slanted = math::normalize(Vec3d{1, 1, 0});
    const auto color = [&](Vec3d l, Vec3d r, double shininess, bool highlights) {
        return renderer::phong(n, l, r, kd, ks, shininess, highlights);
    };
    CHECK(color(n, n, 10, true) == Vec3d{1.5, 1.25, 1});
    CHECK(color(n, n, 10, false) == kd);
    CHECK(color(n, n, 0, true) == kd);
    CHECK(color({0, -1, 0}, {0, -1, 0}, 10, true) == Vec3d{});  // from behind
    CHECK(color({1, 0, 0}, {1, 0, 0}, 10, true) == Vec3d{});    // edge-on
    CHECK(color(slanted, {-1, 0, 0}, 10, true).x == doctest::Approx(0.5 * slanted.y));
    CHECK(color(n, slanted, 2, true).z == doctest::Approx(0.5));  // cos(45 degrees)^2
    // Rounding past 1 must not be raised to a huge power.
    CHECK(color(n, {0, 1.0000001, 0}, 1e9, true).z == 1);
}

TEST_CASE_TEMPLATE("frames are orthonormal everywhere", T, float, double) {
    const double tolerance = sizeof(T) == 4 ? 1e-6 : 1e-14;
    for (const Vec3d z : {Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, Vec3d{1, 0, 0}, Vec3d{0, -1, 0},
                          Vec3d{1e-8, 0, -1}, Vec3d{0.3, 0.5, -0.0}, Vec3d{-3, 2, 1}}) {
        const auto frame = renderer::frame_around(math::normalize(z).to<T>());
        CHECK(std::fabs(math::dot(frame.x, frame.y)) < tolerance);
        CHECK(std::fabs(math::dot(frame.x, frame.z)) < tolerance);
        CHECK(std::fabs(math::length(frame.x) - 1) < tolerance);
        CHECK(math::length(math::cross(frame.x, frame.y) - frame.z) < T(4 * tolerance));
    }
}
