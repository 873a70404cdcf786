// SPDX-License-Identifier: MIT
// The published programs as a job: the same bits whatever the tiles, threads and interruptions.
#include <doctest/doctest.h>

#include <array>
#include <chrono>
#include <cstring>

#include "renderer/picture/picture_io.hpp"
#include "tests/compat/small_scene.hpp"
#include "tests/compat/support.hpp"

namespace cobble::test {
namespace {

/// Mirror, glass and marble over a floor, and a mesh-less sky: everything that a tracer does.
ir::Scene still_life(ir::Compat compat) {
    ir::Scene scene;
    scene.compat = compat;
    scene.camera.center = {0, 1, 6};
    scene.camera.forward = {0, 0, -1};
    scene.camera.up = scene.camera.up_as_written = {0, 1, 0};
    scene.camera.right = {1, 0, 0};
    scene.camera.angle = 0.7;
    scene.background.color = {0.3, 0.5, 0.9};
    scene.background.ambient = {0.1, 0.1, 0.1};
    ir::Light light;
    light.position = {3, 6, 4};
    light.color = {1, 0.9, 0.8};
    light.falloff = 0.01;
    scene.lights.push_back(light);
    scene.materials.resize(3);
    scene.materials[0].diffuse = {0.4, 0.6, 0.3};
    scene.materials[1].specular = {0.8, 0.8, 0.8};
    scene.materials[1].refraction_index = 1.5;
    scene.materials[1].shininess = 30;
    scene.materials[2].has_noise = true;
    scene.materials[2].noise = {{0.9, 0.2, 0.1}, {0.1, 0.1, 0.2}, 4, 3, 2};
    scene.materials[2].specular = {0.2, 0.2, 0.2};
    constexpr std::array<double, 3> kX{-1.3, 0.1, 1.4};
    for (std::uint32_t i = 0; i < 3; ++i) add_ball(scene, {kX[i], 1, 0}, 0.7, i);
    ir::Plane floor;
    floor.normal = {0, 1, 0};
    add_plane(scene, floor, 0);
    return scene;
}

renderer::Settings everything(std::uint32_t tile) {
    renderer::Settings settings;
    settings.width = 45;
    settings.height = 37;
    settings.tile_size = tile;
    settings.compat.shadows = settings.compat.jitter = settings.compat.filter = true;
    settings.want_depth = settings.want_normals = settings.want_albedo = true;
    return settings;
}

bool same(const renderer::Plane32& a, const renderer::Plane32& b) {
    return a.values.size() == b.values.size() && !a.values.empty() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

TEST_CASE("tiles and threads change no bit") {
    for (const ir::Compat compat : {ir::Compat::kA5, ir::Compat::kFa2016, ir::Compat::kProject}) {
        const ir::Scene scene = still_life(compat);
        const renderer::Picture one = render(scene, everything(64), 1);
        for (const std::uint32_t tile : {7U, 16U}) {
            for (const std::uint32_t threads : {1U, 3U}) {
                const renderer::Picture other = render(scene, everything(tile), threads);
                CHECK(same(one.color, other.color));
                CHECK(same(one.depth, other.depth));
                CHECK(same(one.normals, other.normals));
                CHECK(same(one.albedo, other.albedo));
            }
        }
    }
}

TEST_CASE("a job put down after every moment gives the same picture, and its samples add up") {
    const ir::Scene scene = still_life(ir::Compat::kA5);
    const renderer::Settings settings = everything(16);
    const auto scheduler = renderer::make_thread_scheduler(2);
    const auto job = renderer::start_render(scene, settings, *scheduler);
    using std::chrono::steady_clock;
    double fraction = 0;
    std::size_t steps = 0;
    for (bool done = false; !done; ++steps) {
        const renderer::Progress progress =
            job->step(steady_clock::now() + std::chrono::microseconds(300));
        CHECK(progress.fraction >= fraction);
        fraction = progress.fraction;
        done = progress.done;
    }
    CHECK(steps > 3);
    CHECK(fraction == doctest::Approx(1));
    CHECK(same(job->picture().color, render(scene, settings, 1).color));
}

TEST_CASE("a crop holds the whole picture's pixels") {
    const ir::Scene scene = still_life(ir::Compat::kA5);
    renderer::Settings settings = everything(16);
    const renderer::Plane32 whole = render(scene, settings, 1).color;
    settings.crop = renderer::Crop{5, 7, 31, 20};
    const renderer::Plane32 part = render(scene, settings, 1).color;
    REQUIRE(part.width == 26);
    REQUIRE(part.height == 13);
    for (std::uint32_t y = 0; y < part.height; ++y) {
        for (std::uint32_t x = 0; x < part.width; ++x) {
            for (std::uint32_t c = 0; c < 3; ++c) {
                REQUIRE(part.at(x, y, c) == whole.at(x + 5, y + 7, c));
            }
        }
    }
}

TEST_CASE("jitter depends on the seed, and on nothing else") {
    const ir::Scene scene = still_life(ir::Compat::kA5);
    renderer::Settings settings = everything(16);
    const renderer::Picture a = render(scene, settings, 1);
    settings.seed = 1;
    const renderer::Picture b = render(scene, settings, 1);
    CHECK_FALSE(same(a.color, b.color));
    CHECK(same(a.depth, b.depth));
    settings.compat.jitter = settings.compat.filter = false;
    const renderer::Picture c = render(scene, settings, 1);
    settings.seed = 0;
    CHECK(same(c.color, render(scene, settings, 1).color));
    // The same picture but for its edges: 9 samples each moved by at most a sixth of a pixel.
    CHECK(levels_between(a.color, c.color).mean < 6);
}

TEST_CASE("the project's lens: sharp at the focus, blurred elsewhere") {
    const ir::Scene scene = still_life(ir::Compat::kProject);
    renderer::Settings settings = everything(16);
    settings.compat.jitter = settings.compat.filter = false;
    settings.compat.casting = true;
    const renderer::Plane32 sharp = render(scene, settings, 1).color;
    // The spheres' outlines lie at 6 and a little.
    settings.compat.blurry = 6.0;
    const double focused = levels_between(render(scene, settings, 1).color, sharp).mean;
    settings.compat.blurry = 40.0;
    const double blurred = levels_between(render(scene, settings, 1).color, sharp).mean;
    CHECK(focused < 5);
    CHECK(blurred > 2 * focused);
}

}  // namespace
}  // namespace cobble::test
