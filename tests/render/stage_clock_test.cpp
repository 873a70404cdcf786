// SPDX-License-Identifier: MIT
#include "renderer/tile/stage_clock.hpp"

#include <doctest/doctest.h>

#include "tests/render/everything.hpp"
#include "tests/render/scene_builder.hpp"

namespace cobble::test {
namespace {

using renderer::Acceleration;
using renderer::ErrorGoal;
using renderer::Settings;
using renderer::StageTimes;
using renderer::TimedStage;

double of(const StageTimes& times, TimedStage stage) {
    return times.seconds[static_cast<std::size_t>(stage)];
}

double render_seconds(const Rendered& rendered) {
    for (const renderer::PhaseTime& phase : rendered.stats.phases) {
        if (phase.name == "render") return phase.seconds;
    }
    return 0;
}

TEST_CASE("each stage that a render goes through takes time, and no other") {
    SceneBuilder b = everything();
    Settings settings = test::settings(32, 24, 4);
    const Rendered untimed = render(b.scene(), settings);
    CHECK(untimed.stats.stages.sum() == 0);
    settings.time_stages = true;
    const Rendered timed = render(b.scene(), settings);
    CHECK(timed.picture.color.values == untimed.picture.color.values);
    for (const TimedStage stage :
         {TimedStage::kCamera, TimedStage::kHits, TimedStage::kSurfaces, TimedStage::kLights,
          TimedStage::kShadows, TimedStage::kColors, TimedStage::kOnward, TimedStage::kPixels}) {
        CAPTURE(renderer::name_of(stage));
        CHECK(of(timed.stats.stages, stage) > 0);
    }
    CHECK(of(timed.stats.stages, TimedStage::kErrors) == 0);
    CHECK(of(timed.stats.stages, TimedStage::kRayByRay) == 0);
    // One worker: nothing can be counted twice.
    CHECK(timed.stats.stages.sum() <= render_seconds(timed));

    settings.effects = without(settings.effects, ir::Effect::kShadows);
    const Rendered bare = render(b.scene(), settings);
    CHECK(of(bare.stats.stages, TimedStage::kShadows) == 0);

    settings.acceleration = Acceleration::kBvh;
    const Rendered reference = render(b.scene(), settings);
    CHECK(of(reference.stats.stages, TimedStage::kRayByRay) > 0);
    CHECK(of(reference.stats.stages, TimedStage::kHits) == 0);
}

TEST_CASE("looks at the error are a stage too") {
    SceneBuilder b = everything();
    Settings settings = test::settings(16, 12, 1);
    settings.time_stages = true;
    settings.goal = ErrorGoal{};
    settings.goal->error = 0.2;
    const Rendered timed = render(b.scene(), settings, 2);
    CHECK(of(timed.stats.stages, TimedStage::kErrors) > 0);
    CHECK(timed.stats.stages.sum() <= timed.stats.workers * render_seconds(timed));
}

}  // namespace
}  // namespace cobble::test
