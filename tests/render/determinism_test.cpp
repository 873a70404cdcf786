// SPDX-License-Identifier: MIT
// One picture, to the bit, however it is computed.
#include <doctest/doctest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <vector>

#include "renderer/job/fp_environment.hpp"
#include "tests/render/everything.hpp"
#include "tests/render/same.hpp"

using namespace cobble;
using namespace cobble::test;

TEST_CASE("threads, tiles and deadlines leave no trace") {
    SceneBuilder b = everything();
    renderer::Settings s = full(50, 37, 6);
    for (const auto precision : {renderer::Precision::kFloat, renderer::Precision::kDouble}) {
        s.precision = precision;
        s.acceleration = renderer::Acceleration::kBvh;
        s.tile_size = 32;
        const Rendered reference = render(b.scene(), s);
        CHECK(reference.stats.bad_sample_count == 0);
        CHECK(reference.stats.counters.refracted_rays > 0);
        for (const std::uint32_t threads : {1U, 2U, 3U, 7U}) {
            for (const std::uint32_t tile : {1U, 8U, 13U, 32U, 128U}) {
                s.tile_size = tile;
                CAPTURE(threads);
                CAPTURE(tile);
                s.acceleration = renderer::Acceleration::kBvh;
                const Rendered other = render(b.scene(), s, threads);
                CHECK(same(reference.picture, other.picture));
                CHECK(same(reference.stats.counters, other.stats.counters));
                s.acceleration = renderer::Acceleration::kFast;
                const Rendered fast = render(b.scene(), s, threads);
                CHECK(same(reference.picture, fast.picture));
                CHECK(same_rays(reference.stats.counters, fast.stats.counters));
            }
        }
    }
}

TEST_CASE("deadlines that have always passed leave no trace") {
    // Each step follows one ray, or a batch through one stage, and is stopped: every place where a
    // tile can be put down is one.
    SceneBuilder b = everything();
    renderer::Settings s = full(14, 11, 2);
    for (const auto core : {renderer::Acceleration::kBvh, renderer::Acceleration::kFast}) {
        s.acceleration = core;
        for (const std::uint32_t tile : {5U, 11U}) {
            s.tile_size = tile;
            const Rendered reference = render(b.scene(), s);
            for (const std::uint32_t threads : {1U, 3U}) {
                const Rendered hurried = render(b.scene(), s, threads, -1);
                CHECK(same(reference.picture, hurried.picture));
                CHECK(same(reference.stats.counters, hurried.stats.counters));
            }
        }
    }
}

TEST_CASE("brute force and the tree give one picture") {
    SceneBuilder b = everything();
    renderer::Settings s = full(40, 30, 3);
    s.acceleration = renderer::Acceleration::kBvh;
    const Rendered tree = render(b.scene(), s);
    s.acceleration = renderer::Acceleration::kBruteForce;
    CHECK(same(tree.picture, render(b.scene(), s).picture));
}

TEST_CASE("a host that flushes denormals and rounds oddly gets the same picture") {
    SceneBuilder b = everything();
    const renderer::Settings s = full(24, 18, 2);
    const Rendered reference = render(b.scene(), s);
    const int rounding = std::fegetround();
    std::fesetround(FE_UPWARD);
#if defined(__SSE2__)
    const std::uint32_t before = _mm_getcsr();
    _mm_setcsr(before | 0x8040U);
#endif
    const Rendered odd = render(b.scene(), s);
    const Rendered odd_threads = render(b.scene(), s, 3);
#if defined(__SSE2__)
    _mm_setcsr(before);
#endif
    std::fesetround(rounding);
    CHECK(same(reference.picture, odd.picture));
    CHECK(same(reference.picture, odd_threads.picture));
}

TEST_CASE("a crop is that part of the whole") {
    SceneBuilder b = everything();
    renderer::Settings s = full(50, 37, 3);
    const Rendered whole = render(b.scene(), s);
    s.crop = renderer::Crop{7, 11, 30, 37};
    const Rendered part = render(b.scene(), s, 2);
    REQUIRE(part.picture.color.width == 23);
    REQUIRE(part.picture.color.height == 26);
    bool equal = true;
    for (std::uint32_t y = 0; y < 26; ++y) {
        for (std::uint32_t x = 0; x < 23; ++x) {
            equal = equal && part.color(x, y) == whole.color(x + 7, y + 11);
        }
    }
    CHECK(equal);
    CHECK(part.stats.counters.camera_rays == 23 * 26 * 3);

    s.crop = renderer::Crop{60, 0, 70, 5};
    const Rendered nothing = render(b.scene(), s);
    CHECK(nothing.picture.color.values.empty());
    CHECK(nothing.picture.complete);
}

TEST_CASE("shards share out the pixels, each rendered once") {
    SceneBuilder b = everything();
    renderer::Settings s = full(50, 37, 2);
    s.tile_size = 8;
    const Rendered whole = render(b.scene(), s);
    std::vector<int> owners(50 * 37, 0);
    bool equal = true;
    std::uint64_t rays = 0;
    s.shard_count = 3;
    for (s.shard_index = 0; s.shard_index < 3; ++s.shard_index) {
        const Rendered shard = render(b.scene(), s);
        rays += shard.stats.counters.camera_rays;
        for (std::uint32_t y = 0; y < 37; ++y) {
            for (std::uint32_t x = 0; x < 50; ++x) {
                if (shard.picture.sample_count.at(x, y, 0) == 0) {
                    equal = equal && shard.color(x, y) == Color{};
                    continue;
                }
                ++owners[y * 50 + x];
                equal = equal && shard.color(x, y) == whole.color(x, y);
            }
        }
    }
    CHECK(equal);
    CHECK(std::count(owners.begin(), owners.end(), 1) == 50 * 37);
    CHECK(rays == 50 * 37 * 2);
}

TEST_CASE("another seed is another picture of the same thing") {
    SceneBuilder b = everything();
    renderer::Settings s = full(20, 15, 64);
    const Rendered one = render(b.scene(), s);
    s.seed = 1;
    const Rendered other = render(b.scene(), s);
    CHECK_FALSE(same(one.picture, other.picture));
    double difference = 0;
    for (std::size_t i = 0; i < one.picture.color.values.size(); ++i) {
        difference +=
            static_cast<double>(one.picture.color.values[i] - other.picture.color.values[i]) /
            static_cast<double>(one.picture.color.values.size());
    }
    CHECK(std::fabs(difference) < 3e-3);
}
