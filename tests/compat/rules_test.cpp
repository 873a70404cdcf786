// SPDX-License-Identifier: MIT
// What each published program does, on scenes small enough to work out by hand.
#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "renderer/compat/camera.hpp"
#include "renderer/compat/filter.hpp"
#include "renderer/compat/pictures.hpp"
#include "renderer/compat/texture.hpp"
#include "tests/compat/small_scene.hpp"
#include "tests/compat/support.hpp"

namespace cobble::renderer {
namespace {

using ir::Compat;
using test::add_ball;
using test::add_dot;
using test::add_picture_frame;
using test::add_plane;
using test::add_wall;
using test::middle;
using test::plain_scene;
using test::red;
using test::sized;

TEST_CASE("pixels lie at 2 i / (w - 1) - 1, and pictures that are not square are stretched") {
    const ir::Scene scene = plain_scene(Compat::kA4);
    const CompatCamera camera(scene.camera, rules_of(Compat::kA4, {}), 5, 3);
    // tan 45 degrees = 1: the corner ray is (-1, 1, -1).
    const math::Vec3d corner = camera.direction(0, 0, 0, 0);
    CHECK(corner.x / -corner.z == doctest::Approx(-1));
    CHECK(corner.y / -corner.z == doctest::Approx(1));
    const math::Vec3d other = camera.direction(3, 1, 0, 0);
    CHECK(other.x / -other.z == doctest::Approx(0.5));
    CHECK(other.y == doctest::Approx(0));
    // Half a sample to the right and upwards.
    const math::Vec3d moved = camera.direction(3, 1, 0.5, 0.5);
    CHECK(moved.x / -moved.z == doctest::Approx(0.75));
    CHECK(moved.y / -moved.z == doctest::Approx(0.5));
}

TEST_CASE("one pixel, one row: no division by zero") {
    ir::Scene scene = plain_scene(Compat::kA4);
    add_wall(scene, 0);
    for (const auto& [w, h] : {std::pair{1U, 1U}, {4U, 1U}, {1U, 4U}}) {
        const Picture picture = test::render(scene, sized(w, h), 1);
        for (const float value : picture.color.values) CHECK(std::isfinite(value));
    }
}

TEST_CASE("2016 takes `up` as written") {
    ir::Scene scene = plain_scene(Compat::kFa2016);
    scene.camera.up_as_written = {0, 2, 0};
    const CompatCamera camera(scene.camera, rules_of(Compat::kFa2016, {}), 3, 3);
    const math::Vec3d top = camera.direction(1, 0, 0, 0);
    CHECK(top.y / -top.z == doctest::Approx(2));
    const CompatCamera before(scene.camera, rules_of(Compat::kA5, {}), 3, 3);
    CHECK(before.direction(1, 0, 0, 0).y / -before.direction(1, 0, 0, 0).z == doctest::Approx(1));
}

/// A wall with a red highlight of 0.25, lit along `light`.
ir::Scene shiny_wall(Compat compat, double shininess, math::Vec3d light, double facing = 1) {
    ir::Scene scene = plain_scene(compat);
    scene.materials[0].specular = {0.25, 0, 0};
    scene.materials[0].shininess = shininess;
    scene.lights[0].direction = light;
    add_wall(scene, 0, 0, facing);
    return scene;
}

TEST_CASE("highlights: dropped by the tracer of 2012 alone, everywhere without shininess") {
    const auto with = [](Compat compat, double shininess) {
        Settings settings = sized(3, 3);
        settings.bounces = 0;
        return red(shiny_wall(compat, shininess, {0, 0, -1}), settings);
    };
    CHECK(with(Compat::kA4, 20) == doctest::Approx(0.75));
    CHECK(with(Compat::kFa2016, 20) == doctest::Approx(0.75));
    CHECK(with(Compat::kProject, 20) == doctest::Approx(0.75));
    CHECK(with(Compat::kA5, 20) == doctest::Approx(0.5));
    CHECK(with(Compat::kA4, 0) == doctest::Approx(0.75));
}

TEST_CASE("highlights on the unlit side: the view ray reflected, or the project's clamped light") {
    const math::Vec3d forwards{0, 0, -1};
    const math::Vec3d backwards{0, 0, 1};
    const struct {
        double facing;
        Compat compat;
        math::Vec3d light;
        double red;
    } cases[] = {
        // The wall faces away from camera and light: N.L = -1, and the reflected view ray points at
        // the light; but light from the camera's side is opposite to d, so max(0, L.d) is 0.
        {-1, Compat::kA4, forwards, 0.25},
        {-1, Compat::kProject, forwards, 0},
        // Seen from in front, lit from behind: L.d = 1.
        {1, Compat::kA4, backwards, 0},
        {1, Compat::kProject, backwards, 0.25},
    };
    for (const auto& c : cases) {
        CAPTURE(c.facing);
        CHECK(red(shiny_wall(c.compat, 1, c.light, c.facing), sized(3, 3)) ==
              doctest::Approx(c.red));
    }
}

TEST_CASE("falloff: none, one plus, proportional") {
    const auto with = [](Compat compat, double falloff) {
        ir::Scene scene = plain_scene(compat);
        scene.lights[0].kind = ir::Light::Kind::kPoint;
        scene.lights[0].position = {0, 0, 2};
        scene.lights[0].falloff = falloff;
        add_wall(scene, 0);
        return red(scene, sized(3, 3));
    };
    CHECK(with(Compat::kA4, 0.5) == doctest::Approx(0.5));
    CHECK(with(Compat::kA5, 0.5) == doctest::Approx(0.5 / 3));
    CHECK(with(Compat::kProject, 0.5) == doctest::Approx(0.5 / 3));
    CHECK(with(Compat::kFa2016, 0.5) == doctest::Approx(0.5 / 2));
    CHECK(with(Compat::kFa2016, 0) == doctest::Approx(0.5));
}

TEST_CASE("shadows only where asked for, and never in the ray casters") {
    const auto with = [](Compat compat, bool casting, bool shadows) {
        ir::Scene scene = plain_scene(compat);
        add_wall(scene, 0);
        // Behind the camera, between light and wall.
        add_wall(scene, 10);
        Settings settings = sized(3, 3);
        settings.compat.casting = casting;
        settings.compat.shadows = shadows;
        return red(scene, settings);
    };
    CHECK(with(Compat::kA5, false, false) == doctest::Approx(0.5));
    CHECK(with(Compat::kA5, false, true) == 0);
    CHECK(with(Compat::kFa2016, false, true) == 0);
    CHECK(with(Compat::kProject, false, true) == 0);
    CHECK(with(Compat::kA4, false, true) == doctest::Approx(0.5));
    CHECK(with(Compat::kProject, true, true) == doctest::Approx(0.5));
}

TEST_CASE("a point light hides behind things that are nearer than it") {
    ir::Scene scene = plain_scene(Compat::kA5);
    scene.lights[0].kind = ir::Light::Kind::kPoint;
    scene.lights[0].position = {0, 0, 6};
    add_wall(scene, 0);
    add_wall(scene, 7);  // beyond the light
    Settings settings = sized(3, 3);
    settings.compat.shadows = true;
    CHECK(red(scene, settings) == doctest::Approx(0.5));
    add_wall(scene, 5.5);  // before it, behind the camera
    CHECK(red(scene, settings) == 0);
}

TEST_CASE("mirrors: a bounce adds the specular colour times what it sees") {
    ir::Scene scene = plain_scene(Compat::kA5);
    scene.materials[0].diffuse = {};
    scene.materials[0].specular = {0.5, 0.5, 0.5};
    add_wall(scene, 0);
    add_wall(scene, 6, 1, -1);  // behind the camera, lit by nothing but ambient light
    scene.background.ambient = {0.5, 0, 0};
    scene.materials.push_back({});
    scene.materials[1].specular = {};
    Settings settings = sized(3, 3);
    settings.bounces = 0;
    CHECK(red(scene, settings) == 0);
    settings.bounces = 1;
    CHECK(red(scene, settings) == doctest::Approx(0.25));
    // Two mirrors face to face: 1/4 of the first, and 1/8, 1/16 and so on.
    scene.materials[1] = scene.materials[0];
    scene.materials[0].diffuse = scene.materials[1].diffuse = {1, 1, 1};
    scene.lights.clear();
    settings.bounces = 3;
    CHECK(red(scene, settings) == doctest::Approx(0.5 * (1 + 0.5 + 0.25 + 0.125)));
    // Deep ones cost no stack.
    settings.bounces = 100000;
    CHECK(red(scene, settings) == doctest::Approx(1));
}

/// No light but a white ambient one, all black behind, and a wall of glass of index 2 before the
/// camera; material 1 is red.
ir::Scene glass_scene() {
    ir::Scene scene = plain_scene(Compat::kA5);
    scene.lights.clear();
    scene.background.ambient = {1, 1, 1};
    scene.background.color = {};
    scene.materials[0].diffuse = {};
    scene.materials[0].specular = {1, 1, 1};
    scene.materials[0].refraction_index = 2;
    add_wall(scene, 0);
    scene.materials.push_back({});
    scene.materials[1].diffuse = {1, 0, 0};
    return scene;
}

TEST_CASE("glass: Schlick's reflectance head on, and the index of air behind it") {
    ir::Scene scene = glass_scene();
    add_wall(scene, -3, 1);
    Settings settings = sized(3, 3);
    settings.bounces = 1;
    // ((2 - 1) / (2 + 1))^2 = 1/9 is mirrored into the black background.
    CHECK(red(scene, settings) == doctest::Approx(8.0 / 9));
    // Opaque without an index: all of it is mirrored.
    scene.materials[0].refraction_index = 0;
    CHECK(red(scene, settings) == 0);
}

TEST_CASE("glass: a slab lets 64/81 through head on, and shifts what is seen askew") {
    ir::Scene scene = glass_scene();
    add_wall(scene, -1, 0, -1);
    // A ray of slope 1 meets the glass at x = 5; sin t = sin i / 2 = 0.35355, tan t = 0.37796; it
    // goes on with slope 1 from x = 5.37796 at z = -1.
    add_ball(scene, {0, 0, -3}, 0.05, 1);
    add_ball(scene, {5 + 0.377964 + 2, 0, -3}, 0.05, 1);
    Settings settings = sized(5, 5);
    settings.bounces = 2;
    const Plane32 color = test::render(scene, settings, 1).color;
    CHECK(color.at(2, 2, 0) == doctest::Approx(64.0 / 81));
    // Schlick with the cosine in air, 1 / sqrt 2, both times.
    const double reflectance = 1.0 / 9 + 8.0 / 9 * std::pow(1 - 1 / std::sqrt(2.0), 5);
    CHECK(color.at(4, 2, 0) == doctest::Approx((1 - reflectance) * (1 - reflectance)));
    CHECK(color.at(0, 2, 0) == 0);
}

TEST_CASE("glass: beyond the critical angle all is mirrored") {
    // The camera is inside: the face it looks at is left, from index 1 (the program keeps no
    // account) into air; so begin outside, through a face that the ray crosses head on.
    ir::Scene scene = glass_scene();
    // A slanted face, 45 degrees: sin = 0.707 times 2 is above 1, so the ray turns to -x.
    ir::Plane slanted;
    slanted.normal = math::normalize(math::Vec3d{1, 0, -1});
    slanted.offset = math::dot(slanted.normal, {0, 0, -1});
    add_plane(scene, slanted, 0);
    add_ball(scene, {-2, 0, -1}, 0.1, 1);
    Settings settings = sized(3, 3);
    settings.bounces = 2;
    CHECK(red(scene, settings) == doctest::Approx(8.0 / 9));
}

/// A bright red texture, on a mesh or on a plane.
ir::Scene textured(Compat compat, bool mesh = true) {
    ir::Scene scene = plain_scene(compat);
    scene.materials[0].texture = add_dot(scene, 255, 0, 0);
    mesh ? add_picture_frame(scene) : add_wall(scene, 0);
    return scene;
}

TEST_CASE("only meshes have texture coordinates, and 2016 has no textures") {
    for (const Compat compat : {Compat::kA4, Compat::kA5, Compat::kProject}) {
        CHECK(red(textured(compat, true), sized(3, 3)) == doctest::Approx(1));
        CHECK(red(textured(compat, false), sized(3, 3)) == doctest::Approx(0.5));
    }
    CHECK(red(textured(Compat::kFa2016), sized(3, 3)) == doctest::Approx(0.5));
}

TEST_CASE("ambient light shows the texture in the handout's ray casting alone") {
    for (const auto& [compat, expected] :
         {std::pair{Compat::kA4, 0.5}, {Compat::kA5, 0.25}, {Compat::kProject, 0.25}}) {
        ir::Scene scene = textured(compat);
        scene.lights.clear();
        scene.background.ambient = {0.5, 0.5, 0.5};
        CHECK(red(scene, sized(3, 3)) == doctest::Approx(expected));
    }
}

TEST_CASE("the project's normal maps: red and green count downwards, and others ignore them") {
    const auto with = [](Compat compat, std::uint8_t r, std::uint8_t g, std::uint8_t b,
                         math::Vec3d light) {
        ir::Scene scene = plain_scene(compat);
        scene.materials[0].normal_map = add_dot(scene, r, g, b);
        scene.lights[0].direction = light;
        scene.materials[0].diffuse = {1, 1, 1};
        add_picture_frame(scene);
        return red(scene, sized(3, 3));
    };
    // 0 is 1 and 255 is -1 along u and v.
    CHECK(with(Compat::kProject, 0, 127, 127, {-1, 0, 0}) == doctest::Approx(1).epsilon(1e-3));
    CHECK(with(Compat::kProject, 255, 127, 127, {-1, 0, 0}) == doctest::Approx(0));
    CHECK(with(Compat::kProject, 127, 0, 127, {0, -1, 0}) == doctest::Approx(1).epsilon(1e-3));
    CHECK(with(Compat::kProject, 127, 127, 255, {0, 0, -1}) == doctest::Approx(1).epsilon(1e-3));
    CHECK(with(Compat::kA4, 0, 127, 127, {-1, 0, 0}) == doctest::Approx(0));
}

TEST_CASE("the project's environment-mapped material: half and half, once for each light") {
    ir::Scene scene = plain_scene(Compat::kProject);
    ir::CubeMap map;
    map.faces.fill(add_dot(scene, 102, 0, 0));  // 0.4
    scene.cube_maps.push_back(map);
    scene.materials[0].cube_map = {0};
    scene.background.ambient = {0.1, 0.1, 0.1};
    add_wall(scene, 0);
    const Settings settings = sized(3, 3);
    CHECK(red(scene, settings) == doctest::Approx(0.1 * 0.5 + 0.2));
    scene.lights.push_back(scene.lights[0]);
    CHECK(red(scene, settings) == doctest::Approx(0.1 * 0.5 + 0.4));
    scene.materials[0].has_noise = true;
    scene.materials[0].noise = {{0.6, 0, 0}, {0.6, 0, 0}, 1, 1, 1};
    CHECK(red(scene, settings) == doctest::Approx(0.1 * 0.5 + 2 * (0.2 + 0.3)));
    // The tracer ignores it.
    Settings tracing = settings;
    tracing.compat.casting = false;
    scene.materials[0].has_noise = false;
    CHECK(red(scene, tracing) == doctest::Approx(0.1 * 0.5 + 2 * 0.5));
}

TEST_CASE("noise stands before the texture, and the caster of 2012 has none") {
    for (const auto& [compat, expected] :
         {std::pair{Compat::kA4, 1.0}, {Compat::kA5, 0.2}, {Compat::kProject, 0.2}}) {
        ir::Scene scene = textured(compat);
        scene.materials[0].has_noise = true;
        scene.materials[0].noise = {{0.2, 0, 0}, {0.2, 0, 0}, 1, 1, 1};
        CHECK(red(scene, sized(3, 3)) == doctest::Approx(expected));
    }
}

TEST_CASE("textures: no half texel, no repeat, truncated when nearest") {
    ir::Image image;
    image.width = 2;
    image.height = 2;
    // Rows from the top: 0 100 / 200 40 in red.
    image.bytes = {0, 0, 0, 100, 0, 0, 200, 0, 0, 40, 0, 0};
    const auto red_at = [&image](double u, double v, bool nearest) {
        return compat_texture(image, {u, v}, nearest).x * 255;
    };
    CHECK(red_at(0, 1, false) == doctest::Approx(0));      // top left
    CHECK(red_at(0.5, 1, false) == doctest::Approx(100));  // the second texel
    CHECK(red_at(0.25, 1, false) == doctest::Approx(50));
    CHECK(red_at(0, 0.5, false) == doctest::Approx(200));
    CHECK(red_at(0.25, 0.75, false) == doctest::Approx((0 + 100 + 200 + 40) / 4.0));
    CHECK(red_at(0.25, 0.75, true) == doctest::Approx(0));
    CHECK(red_at(0.49, 1, true) == doctest::Approx(0));
    CHECK(red_at(1, 0, false) == doctest::Approx(40));
    CHECK(red_at(7, -3, false) == doctest::Approx(40));
    CHECK(red_at(-2, 9, false) == doctest::Approx(0));
    CHECK(std::isfinite(red_at(std::nan(""), 0.5, false)));
    CHECK(std::isfinite(red_at(1e300, -1e300, true)));
    // A picture that is not there, where coordinates are no numbers.
    image.missing = true;
    const ir::Color color = compat_texture(image, {std::nan(""), 0.5}, false);
    CHECK(std::isfinite(color.x + color.y + color.z));
}

TEST_CASE("cube maps: the published faces, the back one mirrored as it was") {
    ir::Scene scene;
    ir::CubeMap map;
    for (std::uint32_t face = 0; face < 6; ++face) {
        ir::Image image;
        image.width = image.height = 2;
        // The face's number in red, the column in green, the row from the top in blue.
        const auto f = static_cast<std::uint8_t>(face);
        image.bytes = {f, 0, 0, f, 1, 0, f, 0, 1, f, 1, 1};
        scene.images.push_back(image);
        map.faces[face] = {face};
    }
    const auto look = [&](double x, double y, double z) {
        const ir::Color c = compat_cube_map(scene, map, {x, y, z}) * 255;
        return std::array<int, 3>{static_cast<int>(std::lround(c.x)),
                                  static_cast<int>(std::lround(c.y)),
                                  static_cast<int>(std::lround(c.z))};
    };
    constexpr double k = 0.999;
    CHECK(look(-1, k, -k) == std::array{0, 1, 0});  // left: u against z
    CHECK(look(1, k, k) == std::array{1, 1, 0});    // right
    CHECK(look(k, 1, k) == std::array{2, 1, 0});    // up
    CHECK(look(k, -1, k) == std::array{3, 1, 0});   // down
    CHECK(look(-k, k, 1) == std::array{4, 1, 0});   // front
    CHECK(look(-k, k, -1) == std::array{5, 1, 0});  // back
    CHECK(look(0, 0, 0)[0] == ir::CubeMap::kFront);
}

TEST_CASE("depth and normals pictures") {
    const float inf = std::numeric_limits<float>::infinity();
    const Plane32 depth{5, 1, 1, {2, 8, 13, 18, inf}};
    CHECK(compat_depth_picture(depth, Compat::kA4, 8, 18).values ==
          std::vector<float>{1, 1, 0.5F, 0, 0});
    CHECK(compat_depth_picture(depth, Compat::kFa2016, 8, 18).values ==
          std::vector<float>{0, 0, 0.5F, 1, 1});
    CHECK(compat_depth_picture(depth, Compat::kA4, 13, 13).values ==
          std::vector<float>{1, 1, 0, 0, 0});
    const Plane32 normals{2, 1, 3, {-1, 0.5F, 0, 0, 0, 0}};
    CHECK(compat_normals_picture(normals, Compat::kProject).values ==
          std::vector<float>{1, 0.5F, 0, 0, 0, 0});
    CHECK(compat_normals_picture(normals, Compat::kFa2016).values ==
          std::vector<float>{0, 0.75F, 0.5F, 0.5F, 0.5F, 0.5F});
}

TEST_CASE("the filter: five taps across and upwards, edges repeated, then the mean of nine") {
    Settings settings = sized(4, 4);
    settings.compat.filter = true;
    const CompatRules rules = rules_of(Compat::kA5, settings);
    REQUIRE(rules.grid == 3);
    SampleGrid whole(rules, 4, 4, 0, 0, 4, 4);
    REQUIRE(whole.count() == 144);
    for (std::uint64_t k = 0; k < whole.count(); ++k) whole.set(k, {1, 0, 0});
    // A flat picture gets brighter by the square of the weights' sum.
    CHECK(whole.pixel(0, 0).x == doctest::Approx(1.0011 * 1.0011));
    CHECK(whole.pixel(2, 1).x == doctest::Approx(1.0011 * 1.0011));
    // One bright sample in the middle of pixel (1, 1): the mean sees the middle nine weights.
    for (std::uint64_t k = 0; k < whole.count(); ++k) {
        whole.set(k, {whole.x(k) == 4 && whole.y(k) == 4 ? 1.0 : 0.0, 0, 0});
    }
    constexpr double kMiddle = 0.2339 + 0.2931 + 0.2339;
    CHECK(whole.pixel(1, 1).x == doctest::Approx(kMiddle * kMiddle / 9));
    CHECK(whole.pixel(0, 1).x == doctest::Approx(0.1201 * kMiddle / 9));
    CHECK(whole.pixel(3, 3).x == 0);
    // A stretch of the picture holds what its pixels need, and gives the same.
    SampleGrid part(rules, 4, 4, 1, 1, 2, 2);
    CHECK(part.count() == 49);
    for (std::uint64_t k = 0; k < part.count(); ++k) {
        part.set(k, {part.x(k) == 4 && part.y(k) == 4 ? 1.0 : 0.0, 0, 0});
    }
    CHECK(part.pixel(1, 1).x == whole.pixel(1, 1).x);
}

}  // namespace
}  // namespace cobble::renderer
