// SPDX-License-Identifier: MIT
// A job that was stopped anywhere, however often, and gone on with from its state draws what it
// would have drawn without, to the bit.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "tests/render/everything.hpp"
#include "tests/render/same.hpp"
#include "tests/support/split_mix.hpp"

using namespace cobble;
using namespace cobble::test;
using renderer::Acceleration;

namespace {

/// How a picture is made leaves no trace: so each run may do it in another way.
renderer::Settings another_way(renderer::Settings s, SplitMix64& random) {
    constexpr std::uint32_t kSides[] = {5, 8, 16, 32};
    const std::uint64_t side = random.below(4);
    // Tiles say which pixels are a shard's.
    if (s.shard_count == 1) s.tile_size = kSides[side];
    if (random.below(3) == 0) s.acceleration = Acceleration::kBvh;
    return s;
}

struct Stopped {
    Rendered rendered;
    int stops = 0;
};

/// In runs of a few steps each, of which each goes on from the state that the last one left.
Stopped render_with_stops(const ir::Scene& scene, const renderer::Settings& settings,
                          SplitMix64& random) {
    // Rather than wait for runs that are too short to finish a pixel.
    constexpr int kMostStops = 40;
    Stopped result;
    std::string state;
    for (;; ++result.stops) {
        const renderer::Settings s = another_way(settings, random);
        const auto threads = static_cast<std::uint32_t>(1 + random.below(3));
        const auto scheduler = threads == 1 ? renderer::make_serial_scheduler()
                                            : renderer::make_thread_scheduler(threads);
        std::unique_ptr<renderer::RenderJob> job;
        if (result.stops == 0) {
            job = renderer::start_render(scene, s, *scheduler);
        } else {
            renderer::Resumed resumed = renderer::resume_render(scene, s, *scheduler, state);
            REQUIRE(resumed.problem.empty());
            job = std::move(resumed.job);
        }
        // Of two steps the first prepares the scene, and tiles begin anew in each run.
        const std::uint64_t steps = random.below(random.below(3) == 0 ? 120 : 8);
        const bool last = result.stops == kMostStops;
        renderer::Progress progress;
        for (std::uint64_t i = 0; (i < steps || last) && !progress.done; ++i) {
            progress = job->step(soon(last ? 1000 : 0));
            CHECK(progress.fraction <= 1);
        }
        if (progress.done) {
            result.rendered = {job->picture(), job->stats()};
            return result;
        }
        state = job->state();
    }
}

/// Gives how often it was stopped.
int check_stops(const ir::Scene& scene, const renderer::Settings& s, std::uint64_t seed) {
    const Rendered whole = render(scene, s);
    SplitMix64 random(seed);
    const Stopped result = render_with_stops(scene, s, random);
    const Rendered& stopped = result.rendered;
    CAPTURE(seed);
    CAPTURE(result.stops);
    CHECK(stopped.picture.complete);
    CHECK(same(stopped.picture, whole.picture));
    CHECK(stopped.stats.bad_sample_count == whole.stats.bad_sample_count);
    // Pixels on their way are traced again.
    CHECK(stopped.stats.counters.camera_rays >= whole.stats.counters.camera_rays);
    CHECK(stopped.stats.counters.rays() >= whole.stats.counters.rays());
    REQUIRE(stopped.stats.achieved.has_value() == whole.stats.achieved.has_value());
    if (whole.stats.achieved) {
        CHECK(stopped.stats.achieved->largest == whole.stats.achieved->largest);
        CHECK(stopped.stats.achieved->samples == whole.stats.achieved->samples);
        CHECK(stopped.stats.achieved->beyond_goal == whole.stats.achieved->beyond_goal);
    }
    return result.stops;
}

/// Nothing in it reflects.
SceneBuilder flat() {
    SceneBuilder b;
    b.background({0.2, 0.3, 0.4});
    b.material({0.8, 0.5, 0.2}, {0.4, 0.4, 0.4}, 20);
    b.sphere({0, 0, 0}, 2).sphere({2, 1, -2}, 1).plane({0, 1, 0}, -2);
    b.point_light({3, 6, 5}, {0.9, 0.9, 0.9}, 0.5);
    return b;
}

/// Too bright for a float: infinity on the sphere.
SceneBuilder too_bright() {
    SceneBuilder b;
    b.background({0.25, 0.25, 0.25});
    b.sphere({0, 0, 0}, 1);
    b.scene().objects[0].span.source.value = 3;
    b.sun({0, 0, -1}, {1e300, 1, 1});
    return b;
}

}  // namespace

TEST_CASE("a render that was stopped and resumed is the render that was not") {
    SceneBuilder all = everything();
    SceneBuilder plain = flat();
    int stops = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        renderer::Settings s = full(37, 29, 4);
        if (seed % 4 == 1) s.precision = renderer::Precision::kDouble;
        if (seed % 4 == 2) s.crop = {3, 5, 33, 26};
        if (seed % 4 == 3) s.want_depth = s.want_normals = s.want_albedo = false;
        stops += check_stops(all.scene(), s, seed);
        stops += check_stops(plain.scene(), s, 100 + seed);
    }
    CHECK(stops > 24);
}

TEST_CASE("a shard that was stopped and resumed is the shard that was not") {
    SceneBuilder b = flat();
    for (std::uint32_t shard = 0; shard < 3; ++shard) {
        renderer::Settings s = full(40, 30, 3);
        s.shard_count = 3;
        s.shard_index = shard;
        s.tile_size = 8;
        check_stops(b.scene(), s, 200 + shard);
    }
}

TEST_CASE(
    "so are pictures of several passes, which decide from what there is what else they take") {
    SceneBuilder all = everything();
    SceneBuilder plain = flat();
    int stops = 0;
    for (std::uint64_t seed = 500; seed < 506; ++seed) {
        renderer::Settings s = full(17, 13, 12);
        s.light_samples = 2;
        s.scrambles = 5;
        stops += check_stops(seed % 2 == 0 ? all.scene() : plain.scene(), s, seed);
        using Method = renderer::ErrorGoal::Method;
        for (const auto& [method, error, most] : {std::tuple{Method::kAdaptive, 0.03, 256U},
                                                  {Method::kUnbiased, 0.03, 256U},
                                                  {Method::kGuarantee, 0.4, 200U}}) {
            s.goal = renderer::ErrorGoal{error, method, most};
            stops += check_stops(plain.scene(), s, 10 * seed);
        }
    }
    CHECK(stops > 48);
}

TEST_CASE("so are the published programs' pictures, whose pixels depend on their neighbours") {
    SceneBuilder b = flat();
    b.scene().compat = ir::Compat::kProject;
    renderer::Settings s = full(24, 18, 1);
    s.compat.jitter = s.compat.filter = s.compat.shadows = true;
    for (std::uint64_t seed = 300; seed < 304; ++seed) check_stops(b.scene(), s, seed);
}

TEST_CASE("samples that are no numbers are counted once, and found where they are") {
    SceneBuilder b = too_bright();
    // So many samples that the reference often stops in the middle of a pixel.
    renderer::Settings s = full(65, 65, 7);
    const Rendered whole = render(b.scene(), s);
    REQUIRE(whole.stats.bad_sample_count > 16);
    // The same scene, further down in its file.
    SceneBuilder moved = too_bright();
    moved.scene().objects[0].span = {{5}, 1000, 1010};
    int stops = 0;
    for (std::uint64_t seed = 400; seed < 406; ++seed) {
        SplitMix64 random(seed);
        const Stopped stopped = render_with_stops(b.scene(), s, random);
        stops += stopped.stops;
        CHECK(stopped.rendered.stats.bad_sample_count == whole.stats.bad_sample_count);
        REQUIRE(stopped.rendered.stats.bad_samples.size() == 16);
        for (std::size_t i = 0; i < 16; ++i) {
            const renderer::BadSample& bad = stopped.rendered.stats.bad_samples[i];
            const renderer::BadSample& expected = whole.stats.bad_samples[i];
            CHECK(bad.x == expected.x);
            CHECK(bad.y == expected.y);
            CHECK(bad.sample == expected.sample);
            CHECK(bad.span == expected.span);
        }
    }
    CHECK(stops > 6);
    const auto scheduler = renderer::make_serial_scheduler();
    const auto job = renderer::start_render(b.scene(), s, *scheduler);
    while (!job->step(soon(1000)).done) {
    }
    const auto again = renderer::resume_render(moved.scene(), s, *scheduler, job->state());
    REQUIRE(again.job != nullptr);
    CHECK(again.job->stats().bad_samples.at(0).span == moved.scene().objects[0].span);
}

TEST_CASE("the state of a render that is done is all of it") {
    SceneBuilder b = everything();
    const renderer::Settings s = full(20, 15, 2);
    const auto scheduler = renderer::make_serial_scheduler();
    const auto job = renderer::start_render(b.scene(), s, *scheduler);
    while (!job->step(soon(1000)).done) {
    }
    const renderer::Resumed again = renderer::resume_render(b.scene(), s, *scheduler, job->state());
    REQUIRE(again.job != nullptr);
    CHECK(again.job->picture().complete);
    CHECK(same(again.job->picture(), job->picture()));
    const renderer::Progress progress = again.job->step(soon(0));
    CHECK(progress.done);
    CHECK(progress.fraction == 1);
    CHECK(same(again.job->stats().counters, job->stats().counters));
    CHECK(again.job->stats().phases.at(1).seconds == job->stats().phases.at(1).seconds);
}

TEST_CASE("a state of several passes is refused by a render of another number of them") {
    SceneBuilder b = flat();
    renderer::Settings s = full(20, 15, 8);
    const auto scheduler = renderer::make_serial_scheduler();
    std::string states[2];
    for (std::uint32_t i = 0; i < 2; ++i) {
        s.scrambles = i == 0 ? 1 : 4;
        const auto job = renderer::start_render(b.scene(), s, *scheduler);
        while (job->step(soon(0)).fraction < 0.6) {
        }
        states[i] = job->state();
    }
    s.scrambles = 4;
    CHECK(renderer::resume_render(b.scene(), s, *scheduler, states[1]).problem.empty());
    CHECK_FALSE(renderer::resume_render(b.scene(), s, *scheduler, states[0]).problem.empty());
    s.scrambles = 1;
    CHECK(renderer::resume_render(b.scene(), s, *scheduler, states[0]).problem.empty());
    CHECK_FALSE(renderer::resume_render(b.scene(), s, *scheduler, states[1]).problem.empty());
}

TEST_CASE("bytes that are no state of this render are refused") {
    SceneBuilder b = flat();
    renderer::Settings s = full(20, 15, 2);
    const auto scheduler = renderer::make_serial_scheduler();
    const auto job = renderer::start_render(b.scene(), s, *scheduler);
    while (job->step(soon(0)).fraction < 0.5) {
    }
    const std::string state = job->state();
    const auto problem_of = [&](std::string_view bytes, const renderer::Settings& settings) {
        const renderer::Resumed resumed =
            renderer::resume_render(b.scene(), settings, *scheduler, bytes);
        CHECK((resumed.job == nullptr) == !resumed.problem.empty());
        return resumed.problem;
    };
    CHECK(problem_of(state, s).empty());
    for (std::size_t size = 0; size < state.size(); size += 1 + size / 100) {
        CAPTURE(size);
        CHECK_FALSE(problem_of(std::string_view(state).substr(0, size), s).empty());
    }
    CHECK_FALSE(problem_of(state + "more", s).empty());
    renderer::Settings other = s;
    other.width = 21;
    CHECK(problem_of(state, other) == "its state is of a picture of another size");
    other = s;
    other.want_depth = false;
    CHECK(problem_of(state, other) == "its state has parts that are unknown here");
    // Whatever the damage, nothing worse than a wrong picture comes of it.
    SplitMix64 random(1);
    for (int i = 0; i < 2000; ++i) {
        std::string damaged = state;
        const std::uint64_t at = random.below(i % 2 == 0 ? 200 : state.size());
        damaged[at] = static_cast<char>(random.bits());
        const renderer::Resumed resumed =
            renderer::resume_render(b.scene(), s, *scheduler, damaged);
        CHECK((resumed.job == nullptr) == !resumed.problem.empty());
    }
}
