// SPDX-License-Identifier: MIT
// Pictures of several passes: the same bits however they are made, and what they say of themselves.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "renderer/film/scramble_sums.hpp"
#include "renderer/job/render_job.hpp"
#include "renderer/job/scheduler.hpp"
#include "renderer/passes/adaptive_rounds.hpp"
#include "renderer/passes/guarantee.hpp"
#include "tests/render/everything.hpp"
#include "tests/render/same.hpp"

using namespace cobble;
using namespace cobble::test;
using renderer::ErrorGoal;
using renderer::Settings;

namespace {

Settings with_goal(Settings settings, double error, ErrorGoal::Method method,
                   std::uint32_t most = 4096) {
    settings.goal = ErrorGoal{};
    settings.goal->error = error;
    settings.goal->method = method;
    settings.goal->most_samples = most;
    return settings;
}

/// A ball under a large light: soft edges of shadow, hard ones of the ball.
SceneBuilder soft_scene() {
    SceneBuilder b;
    b.background({0.2, 0.3, 0.5}, {0.1, 0.1, 0.1});
    b.camera({0, 2, 8}, {0, -0.2, -1}, 0.7);
    b.material({0.8, 0.6, 0.4});
    b.plane({0, 1, 0}, 0);
    b.sphere({0, 1, 0}, 1);
    b.point_light({3, 6, 4}, {0.9, 0.9, 0.9}, 1.5);
    return b;
}

void check_same_everywhere(const ir::Scene& scene, const Settings& settings) {
    const Rendered once = render(scene, settings);
    REQUIRE(once.picture.complete);
    for (const std::uint32_t threads : {2U, 3U}) {
        CHECK(same(once.picture, render(scene, settings, threads).picture));
    }
    Settings other = settings;
    other.tile_size = 7;
    CHECK(same(once.picture, render(scene, other, 2, 1).picture));
    other.acceleration = renderer::Acceleration::kBvh;
    const Rendered reference = render(scene, other);
    CHECK(same(once.picture, reference.picture));
    CHECK(same_rays(once.stats.counters, reference.stats.counters));
}

}  // namespace

TEST_CASE("a picture of several passes has one sequence of bits") {
    SceneBuilder all = everything();
    Settings scrambled = full(20, 15, 13);
    scrambled.scrambles = 4;
    check_same_everywhere(all.scene(), scrambled);
    using Method = ErrorGoal::Method;
    for (const Method method : {Method::kAdaptive, Method::kUnbiased}) {
        check_same_everywhere(all.scene(), with_goal(full(12, 9, 1), 0.03, method, 256));
    }
    check_same_everywhere(all.scene(), with_goal(full(4, 3, 1), 0.2, Method::kGuarantee, 512));
}

TEST_CASE("lights asked several times a hit are the same in batches and one by one") {
    SceneBuilder all = everything();
    for (const auto precision : {renderer::Precision::kFloat, renderer::Precision::kDouble}) {
        Settings settings = full(20, 15, 3);
        settings.light_samples = 3;
        settings.precision = precision;
        check_same_everywhere(all.scene(), settings);
    }
    // More of the same light: less noise, the same picture in the end.
    SceneBuilder soft = soft_scene();
    Settings settings =
        test::settings(24, 18, 4, effects({Effect::kShadows, Effect::kSoftShadows}));
    const auto error_of = [&](std::uint32_t light_samples) {
        Settings s = settings;
        s.samples = 32;
        s.scrambles = 8;
        s.light_samples = light_samples;
        return render(soft.scene(), s).stats.achieved->rms;
    };
    CHECK(error_of(8) < 0.8 * error_of(1));
}

TEST_CASE("scrambles share the samples out, and their scatter is the error") {
    SceneBuilder soft = soft_scene();
    Settings settings =
        test::settings(24, 18, 64, effects({Effect::kShadows, Effect::kSoftShadows}));
    settings.scrambles = 8;
    settings.want_sample_count = true;
    const Rendered one = render(soft.scene(), settings);
    for (const float count : one.picture.sample_count.values) CHECK(count == 64);
    REQUIRE(one.stats.achieved);
    CHECK(one.stats.achieved->samples == 64);
    CHECK(one.stats.counters.camera_rays == 24 * 18 * 64);
    // Against a picture of very many: the estimate is within a third of the true error.
    Settings many = settings;
    many.scrambles = 1;
    many.seed = 99;
    many.samples = 1U << 14U;
    const Rendered truth = render(soft.scene(), many, 2);
    double squares = 0;
    const auto& a = one.picture.color.values;
    const auto& b = truth.picture.color.values;
    for (std::size_t i = 0; i < a.size(); ++i) squares += (a[i] - b[i]) * double(a[i] - b[i]);
    const double error = std::sqrt(squares / static_cast<double>(a.size()));
    CHECK(one.stats.achieved->rms > 0.67 * error);
    CHECK(one.stats.achieved->rms < 1.5 * error);
}

TEST_CASE("rounds double the samples, and end where they are told to") {
    using renderer::scramble_samples;
    CHECK(scramble_samples(0, 4096) == 4);
    CHECK(scramble_samples(1, 4096) == 8);
    CHECK(scramble_samples(2, 4096) == 16);
    CHECK(scramble_samples(7, 4096) == 512);
    CHECK(scramble_samples(8, 4096) == 512);
    CHECK(scramble_samples(2, 100) == 12);
    CHECK(scramble_samples(32, 1U << 20U) == 1U << 17U);
}

TEST_CASE("a look at the error is put down at a deadline") {
    SceneBuilder soft = soft_scene();
    constexpr std::uint32_t kRows = 50;
    const Settings goal =
        with_goal(settings(4, kRows, 1, effects({Effect::kShadows, Effect::kSoftShadows})), 0.05,
                  ErrorGoal::Method::kAdaptive);
    const auto scheduler = renderer::make_serial_scheduler();
    const auto job = renderer::start_render(soft.scene(), goal, *scheduler);
    // Each step is over before it begins, and does the least that a step does.
    std::uint32_t most_without_rays = 0;
    std::uint32_t without_rays = 0;
    std::uint64_t rays = 0;
    for (renderer::Progress progress; !progress.done;) {
        progress = job->step({});
        without_rays = progress.rays == rays ? without_rays + 1 : 0;
        most_without_rays = std::max(most_without_rays, without_rays);
        rays = progress.rays;
    }
    CHECK(most_without_rays >= kRows);
    const Rendered at_once = render(soft.scene(), goal);
    CHECK(job->picture().color.values == at_once.picture.color.values);
}

TEST_CASE("an error to reach is reached, by as many samples as each pixel needs") {
    SceneBuilder soft = soft_scene();
    const ir::Effects on = effects({Effect::kShadows, Effect::kSoftShadows});
    Settings goal = with_goal(settings(32, 24, 1, on), 0.02, ErrorGoal::Method::kAdaptive);
    goal.want_sample_count = true;
    const Rendered adaptive = render(soft.scene(), goal, 2);
    REQUIRE(adaptive.stats.achieved);
    CHECK(adaptive.stats.achieved->largest <= 0.02);
    CHECK(adaptive.stats.achieved->beyond_goal == 0);
    CHECK(adaptive.stats.achieved->fewest == renderer::kFewestSamples);
    CHECK(adaptive.stats.achieved->most > 2 * renderer::kFewestSamples);
    CHECK(adaptive.stats.achieved->forecast.has_value());
    Settings many = settings(32, 24, 1U << 13U, on);
    many.seed = 5;
    const Rendered truth = render(soft.scene(), many, 2);
    const auto missed = [&](const renderer::Plane32& color) {
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < color.values.size() / 3; ++i) {
            double off = 0;
            for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
                off = std::max<double>(off,
                                       std::fabs(color.values[c] - truth.picture.color.values[c]));
            }
            count += off > 0.02 ? 1 : 0;
        }
        return count;
    };
    CHECK(missed(adaptive.picture.color) <= 0.05 * 32 * 24);
    // Too few are allowed: it says of how many pixels that is true.
    Settings tight = goal;
    tight.goal->most_samples = 64;
    const Rendered cut = render(soft.scene(), tight, 2);
    CHECK(cut.stats.achieved->beyond_goal > 0);
    CHECK(cut.stats.achieved->most == 64);

    Settings unbiased = goal;
    unbiased.goal->method = ErrorGoal::Method::kUnbiased;
    const Rendered fresh = render(soft.scene(), unbiased, 2);
    CHECK(missed(fresh.picture.color) <= 0.05 * 32 * 24);
    // As many samples of each pixel, of which none was seen by the rule that chose their number:
    // where all took 64 the picture is that of 64.
    CHECK(same(fresh.picture.sample_count, adaptive.picture.sample_count));
    const Rendered plain = render(soft.scene(), settings(32, 24, 64, on), 2);
    for (std::size_t i = 0; i < 32 * 24; ++i) {
        if (fresh.picture.sample_count.values[i] != 64) continue;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            CHECK(fresh.picture.color.values[c] == plain.picture.color.values[c]);
        }
    }
}

TEST_CASE("a guarantee takes its fewest samples where nothing varies, and clamps") {
    SceneBuilder b;
    b.background({0.25, 0.5, 4});
    Settings goal = with_goal(settings(3, 2, 1), 0.05, ErrorGoal::Method::kGuarantee);
    const Rendered flat = render(b.scene(), goal);
    REQUIRE(flat.stats.achieved);
    CHECK(flat.stats.achieved->most == renderer::guarantee_fewest_samples(0.05));
    CHECK(flat.stats.achieved->largest <= 0.05);
    CHECK(flat.color(1, 1).x == doctest::Approx(0.25));
    CHECK(flat.color(1, 1).z == 1);
    CHECK(renderer::guarantee_fewest_samples(0.01) == 2048);
}
