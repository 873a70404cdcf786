// SPDX-License-Identifier: MIT
// Rays and samples: as many as the scene calls for, and not one more.
#include <doctest/doctest.h>

#include <cstdint>

#include "renderer/integrator/active_effects.hpp"
#include "tests/effects/work_of.hpp"
#include "tests/render/everything.hpp"
#include "tests/render/same.hpp"

using namespace cobble;
using namespace cobble::test;

namespace {

constexpr std::uint32_t kWidth = 13;
constexpr std::uint32_t kHeight = 7;

renderer::Counters counters_of(const ir::Scene& scene, std::uint32_t mask, std::uint32_t samples) {
    return render(scene, settings(kWidth, kHeight, samples, effects_of_mask(mask))).stats.counters;
}

}  // namespace

TEST_CASE(
    "where nothing but what the camera sees is simulated there are width x height x spp rays") {
    SceneBuilder b = everything();
    for (const std::uint32_t samples : {1U, 3U, 200U}) {
        const renderer::Counters counters = counters_of(b.scene(), 0, samples);
        CHECK(counters.rays() == std::uint64_t{kWidth} * kHeight * samples);
        CHECK(counters.camera_rays == counters.rays());
    }
}

TEST_CASE("each camera ray draws one place on the lens and one moment, or none") {
    SceneBuilder b = everything();
    const std::uint64_t rays = std::uint64_t{kWidth} * kHeight * 3;
    const auto lens = counters_of(b.scene(), renderer::bit_of(Effect::kDepthOfField), 3);
    CHECK(lens.lens_draws == rays);
    CHECK(lens.time_draws == 0);
    const auto time = counters_of(b.scene(), renderer::bit_of(Effect::kMotionBlur), 3);
    CHECK(time.lens_draws == 0);
    CHECK(time.time_draws == rays);
    CHECK(counters_of(b.scene(), kAllEffects, 3).lens_draws == rays);
}

TEST_CASE("a light without a size draws nothing beside one that has a size") {
    SceneBuilder b;
    b.background({}).material({1, 1, 1});
    b.sphere({0, 0, 0}, 100);
    b.point_light({0, 0, 50}, {1, 1, 1}).point_light({0, 5, 50}, {1, 1, 1}, 2);
    // The camera is inside the ball: every ray meets it.
    const auto both = counters_of(b.scene(), renderer::bit_of(Effect::kSoftShadows), 1);
    CHECK(both.light_draws == std::uint64_t{kWidth} * kHeight);
    b.scene().lights[1].radius = 0;
    CHECK(counters_of(b.scene(), renderer::bit_of(Effect::kSoftShadows), 1).light_draws == 0);
}

TEST_CASE("a light that sends nothing casts no shadow ray") {
    SceneBuilder b;
    b.background({}).camera({0, 0, 10}, {0, 0, -1}, 0.5).material({1, 1, 1});
    b.plane({0, 0, 1}, 0);
    const std::uint64_t pixels = std::uint64_t{kWidth} * kHeight;
    const std::uint32_t shadows = renderer::bit_of(Effect::kShadows);
    b.point_light({0, 0, 5}, {1, 1, 1});
    CHECK(counters_of(b.scene(), shadows, 1).shadow_rays == pixels);
    b.point_light({0, 1, 5}, {0, 0, 0});  // black
    CHECK(counters_of(b.scene(), shadows, 1).shadow_rays == pixels);
    b.point_light({0, 1, -5}, {1, 1, 1});  // behind the wall
    CHECK(counters_of(b.scene(), shadows, 1).shadow_rays == pixels);
    CHECK(counters_of(b.scene(), 0, 1).shadow_rays == 0);
}
