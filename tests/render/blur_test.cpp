// SPDX-License-Identifier: MIT
// Sizes of blurs: of the lens, of shadows, of motion.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/render/scene_builder.hpp"
#include "tests/support/record.hpp"

using namespace cobble;
using namespace cobble::test;

namespace {

constexpr double kPi = 3.141592653589793;

/// Second moment of brightness along x about its mean, in pixels squared.
double spread(const Rendered& r) {
    double sum = 0;
    double first = 0;
    double second = 0;
    for (std::uint32_t y = 0; y < r.picture.color.height; ++y) {
        for (std::uint32_t x = 0; x < r.picture.color.width; ++x) {
            const double value = r.color(x, y).x;
            sum += value;
            first += value * x;
            second += value * x * x;
        }
    }
    return second / sum - (first / sum) * (first / sum);
}

/// Part of a disk of radius 1 that lies to the left of x.
double disk_left_of(double x) {
    if (x <= -1) return 0;
    if (x >= 1) return 1;
    return 1 - (std::acos(x) - x * std::sqrt(1 - x * x)) / kPi;
}

}  // namespace

TEST_CASE("row 37: the circle of confusion has the thin lens's size") {
    // A white dot of 0.1 at distance 10 in a picture 4 wide there, 64 pixels, of which the middle
    // is enough. Some sixteen thousand samples meet the dot: a diameter is good to a third of a
    // percent.
    const double pixels_per_unit = 64 / 4.0;
    const auto measure = [](double aperture, double focus, std::uint32_t blades) {
        SceneBuilder b;
        b.camera({0, 0, 10}, {0, 0, -1}, 2 * std::atan(2.0 / 10)).lens(aperture, focus, blades);
        b.background({}, {1, 1, 1});
        b.material({1, 1, 1});
        b.sphere({0, 0, 0}, 0.1);
        renderer::Settings s = settings(64, 64, 2048);
        s.crop = renderer::Crop{20, 20, 44, 44};
        return spread(render(b.scene(), s));
    };
    const double sharp = measure(0, 10, 0);
    const double aperture = 0.8;
    double worst = 0;
    // Blurs of ten pixels and more: the dot's own edge falls on pixels as it will.
    for (const double focus : {4.0, 5.0, 50.0, 1e9}) {
        const double blur = aperture * std::fabs(10 - focus) / focus;  // diameter at the dot
        // A uniform disk of diameter d has a second moment of d^2 / 16 along an axis; variances of
        // independent blurs add.
        const double diameter = 4 * std::sqrt(measure(aperture, focus, 0) - sharp);
        CAPTURE(focus);
        CHECK(diameter == doctest::Approx(blur * pixels_per_unit).epsilon(0.01));
        worst = std::max(worst, std::fabs(diameter / (blur * pixels_per_unit) - 1));
    }
    record(37, "blur off the thin lens's by " + brief(100 * worst) + " % at most");
    // Three blades: a triangle of circumradius R has (2 + cos(2 pi / 3)) / 12 R^2 = R^2 / 8; from a
    // focus at half the distance R is half the aperture.
    CHECK(std::sqrt(8 * (measure(aperture, 5, 3) - sharp)) ==
          doctest::Approx(aperture / 2 * pixels_per_unit).epsilon(0.01));
}

TEST_CASE("a round light's penumbra is as wide and as deep as geometry says") {
    // Straight down on a floor; a light of radius 0.5 at height 20, the edge of a half plane at
    // height 10 over x = 0. A point x on the floor sees of the light what is left of
    // (20 - 0) ... the line from (x, 0) over (0, 10) meets height 20 at -x: so the part of the disk
    // with centre 0 that lies to the side of -x that the half plane, at positive x, does not cover.
    const double height = 20;
    SceneBuilder b;
    b.camera({0, 1, 0}, {0, -1, 0}, 2 * std::atan(1.0));  // 2 units wide
    b.material({1, 1, 1});
    b.plane({0, 1, 0}, 0);
    b.material({1, 1, 1});
    b.triangle({0, 10, -1000}, {0, 10, 1000}, {2000, 10, 0});
    b.point_light({0, height, 0}, {1, 1, 1}, 0.5);
    renderer::Settings s = settings(64, 1, 256);
    s.height = 64;
    s.crop = renderer::Crop{0, 31, 64, 32};
    const Rendered shadowed = render(b.scene(), s);
    s.effects = without(all_effects(), Effect::kShadows);
    const Rendered lit = render(b.scene(), s);
    for (std::uint32_t i = 0; i < 64; ++i) {
        const double x = (i + 0.5) / 32 - 1;
        const double visible = shadowed.color(i, 0).x / lit.color(i, 0).x;
        CAPTURE(x);
        CHECK(std::fabs(visible - disk_left_of(-x / 0.5)) < 0.02);
    }
}

TEST_CASE("a sun's penumbra is its angle times the distance") {
    const double diameter = 0.1;
    SceneBuilder b;
    b.camera({0, 1, 0}, {0, -1, 0}, 2 * std::atan(1.0));
    b.material({1, 1, 1});
    b.plane({0, 1, 0}, 0);
    b.material({1, 1, 1});
    b.triangle({0, 10, -1000}, {0, 10, 1000}, {2000, 10, 0});
    b.sun({0, -1, 0}, {1, 1, 1}, diameter);
    renderer::Settings s = settings(64, 64, 256);
    s.crop = renderer::Crop{0, 31, 64, 32};
    const Rendered shadowed = render(b.scene(), s);
    for (std::uint32_t i = 0; i < 64; ++i) {
        const double x = (i + 0.5) / 32 - 1;
        // Half width 10 tan(0.05) = 0.5.
        CHECK(std::fabs(shadowed.color(i, 0).x - disk_left_of(-x / (10 * std::tan(diameter / 2)))) <
              0.02);
    }
}

TEST_CASE("at the ends of the shutter things stand exactly where their keys say") {
    const Vec3d from{-0.37, 0.11, 0.2};
    const Vec3d to{0.53, -0.29, -0.7};
    const auto picture = [&](bool moving, Vec3d where, double time) {
        SceneBuilder b;
        b.background({0.2, 0.2, 0.2}, {0.1, 0.1, 0.1});
        b.camera({0, 0, 5}, {0, 0, -1}, 0.6).shutter(time, time);
        b.material({1, 0.5, 0.25});
        // Behind the camera, so that both scenes have one size, and with it one origin.
        b.sphere({0, 0, 50}, 20);
        moving ? b.moving_sphere(from, to, 0.8) : b.sphere(where, 0.8);
        b.sun({0.3, -1, -0.5}, {0.8, 0.8, 0.8});
        return render(b.scene(), settings(48, 48, 3));
    };
    const auto same = [](const Rendered& a, const Rendered& b) {
        return std::memcmp(a.picture.color.values.data(), b.picture.color.values.data(),
                           a.picture.color.values.size() * sizeof(float)) == 0;
    };
    CHECK(same(picture(true, {}, 0), picture(false, from, 0)));
    CHECK(same(picture(true, {}, 1), picture(false, to, 0)));
    CHECK_FALSE(same(picture(true, {}, 0.5), picture(false, from, 0)));
}

TEST_CASE("a moving dot leaves a trace of its way's length") {
    SceneBuilder b;
    b.camera({0, 0, 10}, {0, 0, -1}, 2 * std::atan(2.0 / 10)).shutter(0.25, 0.75);
    b.background({}, {1, 1, 1});
    b.material({1, 1, 1});
    b.moving_sphere({-1, 0, 0}, {1, 0, 0}, 0.25);
    const double measured = spread(render(b.scene(), settings(64, 64, 256)));
    const double still = spread(
        render(b.scene(), settings(64, 64, 256, without(all_effects(), Effect::kMotionBlur))));
    // Half of the way of 2 units, 16 pixels each; a uniform stretch of length l has l^2 / 12.
    CHECK(std::sqrt(12 * (measured - still)) == doctest::Approx(16).epsilon(0.01));
}
