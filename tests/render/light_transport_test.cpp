// SPDX-License-Identifier: MIT
// Pictures whose pixels are known in closed form.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/render/scene_builder.hpp"

using namespace cobble;
using namespace cobble::test;
using renderer::Precision;

namespace {

constexpr Precision kPrecisions[] = {Precision::kFloat, Precision::kDouble};

/// One pixel, straight ahead.
Rendered one_pixel(const ir::Scene& scene, renderer::Settings s, Precision precision) {
    s.width = s.height = 1;
    s.precision = precision;
    return render(scene, s);
}

}  // namespace

TEST_CASE("an empty scene is its background") {
    SceneBuilder b;
    b.background({0.25, 0.5, 0.75});
    const Rendered r = render(b.scene(), settings(5, 4, 3));
    for (std::uint32_t y = 0; y < 4; ++y) {
        for (std::uint32_t x = 0; x < 5; ++x) CHECK(r.color(x, y) == Color{0.25, 0.5, 0.75});
    }
    CHECK(r.picture.complete);
    CHECK(r.stats.counters.camera_rays == 60);
    CHECK(r.stats.counters.rays() == 60);
}

TEST_CASE("Phong at the middle of a sphere") {
    for (const Precision precision : kPrecisions) {
        SceneBuilder b;
        b.background({}, {0.1, 0.2, 0.3});
        b.material({0.5, 0.25, 1}, {0.4, 0.4, 0.4}, 8);
        b.sphere({0, 0, 0}, 1);
        // From 60 degrees off the normal, 0 0 1, which is also the mirrored view.
        b.sun({-std::sqrt(0.75), 0, -0.5}, {0.8, 0.6, 0.4});
        // The surface would mirror the background too, which is black.
        const Color c = one_pixel(b.scene(), settings(1, 1), precision).color(0, 0);
        const double highlight = 0.4 * std::pow(0.5, 8);
        CHECK(c.x == doctest::Approx(0.1 * 0.5 + 0.8 * (0.5 * 0.5 + highlight)).epsilon(1e-6));
        CHECK(c.y == doctest::Approx(0.2 * 0.25 + 0.6 * (0.25 * 0.5 + highlight)).epsilon(1e-6));
        CHECK(c.z == doctest::Approx(0.3 * 1 + 0.4 * (1 * 0.5 + highlight)).epsilon(1e-6));
    }
}

TEST_CASE("a surface in the way of a light leaves the ambient light") {
    SceneBuilder b;
    b.background({}, {0.25, 0.25, 0.25});
    b.plane({0, 0, 1}, 0);
    b.sphere({3, 0, 3}, 0.5);
    b.point_light({6, 0, 6}, {1, 1, 1});
    CHECK(one_pixel(b.scene(), settings(1, 1), Precision::kFloat).color(0, 0).x == 0.25F);
    const auto no_shadows = without(all_effects(), Effect::kShadows);
    const Rendered lit = one_pixel(b.scene(), settings(1, 1, 1, no_shadows), Precision::kFloat);
    CHECK(lit.color(0, 0).x == doctest::Approx(0.25 + std::sqrt(0.5)));
    CHECK(lit.stats.counters.shadow_rays == 0);
    // A sphere beyond the light hides nothing.
    b.scene().spheres[0].keys[0].center = {8, 0, 8};
    CHECK(one_pixel(b.scene(), settings(1, 1), Precision::kFloat).color(0, 0).x ==
          doctest::Approx(0.25 + std::sqrt(0.5)));
}

TEST_CASE(
    "the back of a plane or triangle is lit toward the viewer, the inside of a sphere is not") {
    const auto lit = [](SceneBuilder& b) {
        b.sun({0, 0, -1}, {1, 1, 1});
        return one_pixel(b.scene(), settings(1, 1), Precision::kFloat).color(0, 0).x;
    };
    SceneBuilder plane;
    plane.plane({0, 0, -1}, 0);
    CHECK(lit(plane) == doctest::Approx(1));
    SceneBuilder triangle;
    triangle.triangle({-1, -1, 0}, {0, 1, 0}, {1, -1, 0});  // clockwise
    CHECK(lit(triangle) == doctest::Approx(1));
    SceneBuilder sphere;
    sphere.sphere({0, 0, 10}, 5);
    CHECK(lit(sphere) == 0);
}

TEST_CASE("a mirror shows what is behind the viewer, tinted") {
    for (const Precision precision : kPrecisions) {
        SceneBuilder b;
        b.background({}, {1, 1, 1});
        b.material({0, 0, 0}, {0.5, 0.25, 1});
        b.plane({0, 0, 1}, 0);
        b.material({0.5, 1, 0.125});
        b.plane({0, 0, -1}, -20);
        const Rendered r = one_pixel(b.scene(), settings(1, 1), precision);
        CHECK(r.color(0, 0).x == 0.25);
        CHECK(r.color(0, 0).y == 0.25);
        CHECK(r.color(0, 0).z == 0.125);
        CHECK(r.stats.counters.reflected_rays == 1);
        CHECK(r.stats.counters.refracted_rays == 0);
        renderer::Settings none = settings(1, 1);
        none.bounces = 0;
        CHECK(one_pixel(b.scene(), none, precision).color(0, 0).x == 0);
    }
}

TEST_CASE("two mirrors reflect each other as often as bounces say, however many") {
    SceneBuilder b;
    b.material({0, 0, 0}, {1, 1, 1});
    b.background({}, {1, 1, 1});
    b.plane({0, 0, 1}, 0);
    b.plane({0, 0, -1}, -20);
    for (const std::uint32_t bounces : {0U, 1U, 7U, 100U, 4000000000U}) {
        renderer::Settings s = settings(1, 1);
        s.bounces = bounces;
        const Rendered r = one_pixel(b.scene(), s, Precision::kFloat);
        CHECK(r.stats.counters.reflected_rays == std::min(bounces, 1000U));
    }
}

TEST_CASE("a slab of glass transmits and reflects what theory says, at any angle") {
    // The sum over all internal reflections of two equal surfaces of reflectance R: 2 R / (1 + R)
    // comes back, (1 - R) / (1 + R) goes through.
    for (const Precision precision : kPrecisions) {
        for (const double degrees : {0.0, 20.0, 45.0, 70.0}) {
            const double angle = degrees * 3.141592653589793 / 180;
            SceneBuilder b;
            b.background({}, {1, 1, 1});
            b.camera({-10 * std::tan(angle), 0, 10}, {std::sin(angle), 0, -std::cos(angle)}, 0.1);
            b.material({0, 0, 0}, {1, 1, 1}, 0, 1.5);
            b.box({-1000, -1000, -1}, {1000, 1000, 0});
            b.material({1, 0, 0});
            b.plane({0, 0, -1}, -20);
            b.material({0, 1, 0});
            b.plane({0, 0, 1}, -20);
            renderer::Settings s = settings(1, 1);
            s.bounces = 24;
            const Color c = one_pixel(b.scene(), s, precision).color(0, 0);
            const double r0 = 0.04;
            const double reflectance = r0 + (1 - r0) * std::pow(1 - std::cos(angle), 5);
            CHECK(c.x == doctest::Approx(2 * reflectance / (1 + reflectance)).epsilon(1e-5));
            CHECK(c.y == doctest::Approx((1 - reflectance) / (1 + reflectance)).epsilon(1e-5));
            CHECK(c.x + c.y == doctest::Approx(1).epsilon(1e-5));
        }
    }
}

TEST_CASE("a closed mesh of glass is entered and left as a box of glass is") {
    // The same box once as a box, once as twelve triangles.
    ir::Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.positions.push_back(
            {(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0});
    }
    constexpr std::uint32_t kQuads[6][4] = {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7},
                                            {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}};
    for (const auto& q : kQuads) {
        const auto corner = [&](std::uint32_t i) {
            return ir::Mesh::Corner{q[i], ir::Mesh::kNone, ir::Mesh::kNone};
        };
        mesh.faces.push_back({{corner(0), corner(1), corner(2)}});
        mesh.faces.push_back({{corner(0), corner(2), corner(3)}});
    }
    mesh.face_offsets.assign(mesh.faces.size(), 0);
    const auto scene = [&](bool as_mesh) {
        SceneBuilder b;
        b.background({0.2, 0.4, 0.8}, {0.5, 0.5, 0.5});
        b.camera({3, 2.5, 5}, {-0.55, -0.45, -1}, 0.6);
        b.material({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, 0, 1.5);
        as_mesh ? b.mesh(mesh) : b.box({-1, -1, -1}, {1, 1, 1});
        b.material({1, 0.5, 0.2});
        b.plane({0, 1, 0}, -1.5);
        return b;
    };
    renderer::Settings s = settings(40, 30);
    s.precision = Precision::kDouble;
    SceneBuilder box = scene(false);
    SceneBuilder triangles = scene(true);
    const Rendered a = render(box.scene(), s);
    const Rendered m = render(triangles.scene(), s);
    int differ = 0;
    for (std::uint32_t y = 0; y < 30; ++y) {
        for (std::uint32_t x = 0; x < 40; ++x) {
            if (math::length(a.color(x, y) - m.color(x, y)) > 1e-5) ++differ;
        }
    }
    CHECK(differ == 0);
    CHECK(a.stats.counters.refracted_rays > 400);
    CHECK(m.stats.counters.refracted_rays == a.stats.counters.refracted_rays);
}

TEST_CASE(
    "row 30: energy: in a white world, glass and mirrors of any shape give back no more than "
    "white") {
    for (const double index : {0.5, 1.0, 1.33, 1.5, 2.4}) {
        SceneBuilder b;
        b.background({1, 1, 1});
        b.material({0, 0, 0}, {1, 1, 1}, 0, index);
        b.sphere({0, 0, 0}, 2);
        b.sphere({0.5, 0.3, 0.2}, 1);  // nested
        b.box({-4, -1, -3}, {-2.2, 1, -1});
        renderer::Settings s = settings(24, 24);
        s.bounces = 10;
        const Rendered r = render(b.scene(), s);
        for (const float value : r.picture.color.values) {
            CHECK(value <= 1 + 1e-5);
            CHECK(value >= 0.0F);
        }
        CHECK(r.stats.bad_sample_count == 0);
    }
}

TEST_CASE("environment-mapped surfaces show half the surroundings and half their own colour") {
    SceneBuilder b;
    ir::CubeMap map;
    for (std::uint32_t face = 0; face < 6; ++face) {
        ir::Image image;
        image.width = image.height = 2;
        for (int i = 0; i < 4; ++i) {
            image.floats.push_back(static_cast<float>(face));
            image.floats.push_back(1);
            image.floats.push_back(0);
        }
        map.faces[face] = b.image(std::move(image));
    }
    b.scene().cube_maps.push_back(map);
    b.scene().background.cube_map = {0};
    b.material({0.5, 0.5, 0.5}).cube_map = {0};
    b.sphere({0, 0, 0}, 1);
    b.point_light({0, 0, 5}, {1, 1, 1});
    // The sphere's middle mirrors +z, the face called front: 4. No light is added.
    CHECK(one_pixel(b.scene(), settings(1, 1), Precision::kFloat).color(0, 0) ==
          Color{0.5 * 4 + 0.25, 0.5 * 1 + 0.25, 0.25});
    b.scene().objects.clear();
    CHECK(one_pixel(b.scene(), settings(1, 1), Precision::kFloat).color(0, 0) == Color{5, 1, 0});
    const auto off = without(all_effects(), Effect::kEnvironment);
    CHECK(one_pixel(b.scene(), settings(1, 1, 1, off), Precision::kFloat).color(0, 0) == Color{});
}

TEST_CASE("row 30: a normal map, however steep, makes no black mirror and no light from below") {
    ir::Image steep;
    steep.width = steep.height = 16;
    std::uint32_t state = 99;
    for (int i = 0; i < 3 * 256; ++i) {
        state = state * 1664525U + 1013904223U;
        // Blue too: normals that point down into the surface as well.
        steep.bytes.push_back(static_cast<std::uint8_t>(state >> 24U));
    }
    for (const Precision precision : kPrecisions) {
        SceneBuilder mirror;
        mirror.background({1, 1, 1});
        mirror.camera({0, 1, 5}, {0, -0.2, -1}, 0.4);
        const ir::ImageId image = mirror.image(steep);
        mirror.material({0, 0, 0}, {1, 1, 1}).normal_map = image;
        mirror.plane({0, 1, 0}, 0);
        renderer::Settings s = settings(32, 16);
        s.precision = precision;
        const Rendered r = render(mirror.scene(), s);
        for (const float value : r.picture.color.values) CHECK(value == doctest::Approx(1));

        SceneBuilder below;
        below.camera({0, 1, 5}, {0, -0.2, -1}, 0.4);
        const ir::ImageId same = below.image(steep);
        below.material({1, 1, 1}).normal_map = same;
        below.plane({0, 1, 0}, 0);
        below.point_light({0, -1, 0}, {1, 1, 1});
        for (const bool shadows : {true, false}) {
            s.effects = shadows ? all_effects() : without(all_effects(), Effect::kShadows);
            s.height = 8;
            for (const float value : render(below.scene(), s).picture.color.values) {
                CHECK(value == 0.0F);
            }
        }
    }
}

TEST_CASE("row 39: lights on, in and under surfaces are finite") {
    for (const double radius : {0.0, 0.3}) {
        for (const Precision precision : kPrecisions) {
            SceneBuilder b;
            b.background({}, {0.1, 0.1, 0.1});
            b.material({0.8, 0.8, 0.8}, {0.5, 0.5, 0.5}, 1e6);
            b.plane({0, 0, 1}, 0);
            b.sphere({0.5, 0, 0}, 0.4);
            b.point_light({0, 0, 0}, {1, 1, 1}, radius, 3);       // on the plane
            b.point_light({0.5, 0, 0}, {1, 1, 1}, radius);        // inside the sphere
            b.point_light({0.5, 0, 0.4}, {1, 1, 1}, radius);      // on it
            b.point_light({0, 0, -1}, {1, 1, 1}, radius, 1e300);  // under the plane
            b.sun({1, 0, 0}, {1, 1, 1}, radius);                  // along it
            renderer::Settings s = settings(33, 33, 4);
            s.precision = precision;
            const Rendered r = render(b.scene(), s);
            CHECK(r.stats.bad_sample_count == 0);
            for (const float value : r.picture.color.values) CHECK(std::isfinite(value));
        }
    }
}

TEST_CASE("planes of depth, normals, albedo and counts") {
    SceneBuilder b;
    b.background({1, 0, 0});
    b.material({0.25, 0.5, 0.75});
    b.sphere({0, 0, 0}, 1);
    renderer::Settings s = settings(65, 65, 4);
    s.want_depth = s.want_normals = s.want_albedo = s.want_sample_count = true;
    s.samples = 1;
    const Rendered r = render(b.scene(), s);
    CHECK(r.picture.depth.at(32, 32, 0) == doctest::Approx(9));
    CHECK(r.picture.normals.at(32, 32, 2) == doctest::Approx(1));
    CHECK(r.picture.albedo.at(32, 32, 1) == 0.5F);
    CHECK(r.picture.sample_count.at(32, 32, 0) == 1);
    CHECK(std::isinf(r.picture.depth.at(0, 0, 0)));
    CHECK(r.picture.normals.at(0, 0, 2) == 0);
    CHECK(r.picture.albedo.at(0, 0, 0) == 0);
    CHECK(r.picture.sample_count.at(0, 0, 0) == 1);
}
