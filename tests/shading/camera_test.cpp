// SPDX-License-Identifier: MIT
#include "renderer/camera/camera.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

using namespace cobble;
using math::Vec3d;
using renderer::CameraRay;
using renderer::PreparedCamera;

namespace {

ir::Camera looking_ahead(double angle = 1.0) {
    ir::Camera camera;
    camera.forward = {0, 0, -1};
    camera.up = {0, 1, 0};
    camera.right = {1, 0, 0};
    camera.angle = angle;
    return camera;
}

bool same_bits(const CameraRay& a, const CameraRay& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TEST_CASE("the angle spans the height and pixels are square") {
    const double angle = 1.0;
    const PreparedCamera camera(looking_ahead(angle), 300, 100);
    const Vec3d middle = camera.pinhole(150, 50).direction;
    CHECK(middle == Vec3d{0, 0, -1});
    const Vec3d top = camera.pinhole(150, 0).direction;
    CHECK(std::atan2(top.y, -top.z) == doctest::Approx(angle / 2));
    const Vec3d bottom = camera.pinhole(150, 100).direction;
    CHECK(bottom.y == -top.y);
    const Vec3d right = camera.pinhole(300, 50).direction;
    CHECK(right.x / -right.z == doctest::Approx(3 * std::tan(angle / 2)));
    // Mirrored pixels get mirrored rays to the bit.
    const Vec3d a = camera.pinhole(17.5, 3.5).direction;
    const Vec3d b = camera.pinhole(300 - 17.5, 3.5).direction;
    CHECK(a.x == -b.x);
    CHECK(a.y == b.y);
}

TEST_CASE("row 37: a lens without aperture is a pinhole to the bit, at any focus distance") {
    ir::Camera camera = looking_ahead();
    camera.center = {1, 2, 3};
    for (const double focus : {1e-3, 1.0, 7.3, 1e9}) {
        for (const std::uint32_t blades : {0U, 6U}) {
            camera.focus_distance = focus;
            camera.blades = blades;
            const PreparedCamera prepared(camera, 64, 48);
            for (std::uint32_t i = 0; i < 2000; ++i) {
                const renderer::Uniform2 at = renderer::sobol_point(i, 1);
                const renderer::Uniform2 lens = renderer::sobol_point(i, 2);
                CHECK(same_bits(prepared.through_lens(64 * at.x, 48 * at.y, lens),
                                prepared.pinhole(64 * at.x, 48 * at.y)));
            }
        }
    }
}

TEST_CASE(
    "row 37: rays of one point meet in the plane of focus, and spread as a thin lens's elsewhere") {
    ir::Camera camera = looking_ahead();
    camera.aperture = 0.2;
    for (const double focus : {1e-3, 2.0, 50.0, 1e9}) {
        camera.focus_distance = focus;
        const PreparedCamera prepared(camera, 64, 64);
        for (const double depth : {0.5, 2.0, 10.0, 1000.0}) {
            double least = 1e300;
            double largest = -1e300;
            for (std::uint32_t i = 0; i < 4096; ++i) {
                const CameraRay ray = prepared.through_lens(40, 20, renderer::sobol_point(i, 3));
                CHECK(ray.origin.z == 0);
                const double t = depth / -ray.direction.z;
                const double x = ray.origin.x + t * ray.direction.x;
                least = std::fmin(least, x);
                largest = std::fmax(largest, x);
            }
            // Similar triangles: the cone of diameter `aperture` at the lens closes at `focus`.
            const double blur = camera.aperture * std::fabs(1 - depth / focus);
            if (blur == 0) {
                CHECK(largest - least < 1e-12);
            } else {
                CHECK(largest - least == doctest::Approx(blur).epsilon(0.01));
            }
        }
    }
}

TEST_CASE("row 38: extreme angles give finite unit directions") {
    for (const double angle : {1e-9, 1e-3, 3.14, 3.1415926}) {
        const PreparedCamera camera(looking_ahead(angle), 7, 5);
        for (const double x : {0.0, 3.5, 7.0}) {
            const Vec3d d = camera.pinhole(x, 0.5).direction;
            CHECK(std::fabs(math::length(d) - 1) < 1e-12);
        }
    }
}

TEST_CASE("time runs through the shutter's interval; a closed one stands still") {
    ir::Camera camera = looking_ahead();
    camera.shutter_open = 0.1;
    camera.shutter_close = 0.7;
    const PreparedCamera moving(camera, 8, 8);
    CHECK(moving.time(0) == 0.1);
    CHECK(moving.time(1) == doctest::Approx(0.7));
    CHECK(moving.time(0.5) == doctest::Approx(0.4));
    camera.shutter_close = 0.1;
    const PreparedCamera still(camera, 8, 8);
    for (std::uint32_t i = 0; i < 64; ++i) {
        CHECK(still.time(renderer::sobol_point(i, 4).x) == still.time_open());
    }
}
