// SPDX-License-Identifier: MIT
// Batches of rays in stages draw what one ray after the other draws, to the bit.
#include "renderer/intersect/batch.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "renderer/scene/prepared_scene.hpp"
#include "renderer/tile/pixel_order.hpp"
#include "renderer/tile/tiles.hpp"
#include "tests/render/everything.hpp"
#include "tests/render/same.hpp"

using namespace cobble;
using namespace cobble::test;
using renderer::Acceleration;

namespace {

/// Compares the fast way with the reference; gives the reference's render.
Rendered check_both(const ir::Scene& scene, renderer::Settings s, std::uint32_t threads = 1) {
    s.acceleration = Acceleration::kBvh;
    Rendered reference = render(scene, s);
    s.acceleration = Acceleration::kFast;
    const Rendered fast = render(scene, s, threads);
    CHECK(fast.picture.complete);
    CHECK(same(reference.picture, fast.picture));
    CHECK(same_rays(reference.stats.counters, fast.stats.counters));
    CHECK(fast.stats.counters.box_tests > 0);
    CHECK(fast.stats.bad_sample_count == reference.stats.bad_sample_count);
    return reference;
}

template <typename T>
void check_batches(const ir::Scene& scene) {
    renderer::PrepareOptions options;
    options.acceleration = Acceleration::kFast;
    const auto prepared = renderer::prepare<T>(scene, options);
    std::vector<renderer::Ray<T>> rays;
    std::uint32_t state = 1;
    const auto random = [&state] {
        state = state * 1664525U + 1013904223U;
        return static_cast<T>(state >> 8U) / T(1U << 24U);
    };
    for (int i = 0; i < 150; ++i) {
        renderer::Ray<T> ray;
        ray.origin = prepared.to_local({0, 2, 8});
        ray.direction = {random() - T(0.5), random() - T(0.7), -T(1)};
        // Some that run along an axis, and some that end early.
        if (i % 7 == 0) ray.direction.x = 0;
        if (i % 3 == 0) ray.t_max = T(12) * random();
        ray.time = random();
        rays.push_back(ray);
    }
    std::vector<renderer::Exclude> excludes(rays.size());
    for (std::size_t i = 0; i < rays.size(); i += 5) {
        excludes[i] = {ir::ObjectId{static_cast<std::uint32_t>(i % 6)}, 0, i % 2 == 0};
    }
    for (const auto coherence : {renderer::Coherence::kNone, renderer::Coherence::kCoherent}) {
        for (const std::size_t count : {0U, 1U, 3U, 8U, 17U, 64U, 150U}) {
            // What lies behind a batch must stay as it is.
            std::vector<renderer::Hit<T>> hits(count + 1);
            hits[count].t = -5;
            std::vector<std::uint8_t> any(count + 1, 7);
            renderer::Counters counters;
            renderer::closest_hits<T>(prepared, std::span(rays).first(count),
                                      std::span(excludes).first(count),
                                      std::span(hits).first(count), counters, coherence);
            renderer::any_hits<T>(prepared, std::span(rays).first(count),
                                  std::span(excludes).first(count), std::span(any).first(count),
                                  counters, coherence);
            std::size_t found = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const auto hit = closest_hit(prepared, rays[i], excludes[i], counters);
                CHECK(any[i] == (hit ? 1 : 0));
                CHECK(hits[i].object == hit.object);
                if (!hit) continue;
                ++found;
                CHECK(hits[i].t == hit.t);
                CHECK(hits[i].face == hit.face);
                CHECK(hits[i].u == hit.u);
                CHECK(hits[i].v == hit.v);
            }
            CHECK((count < 17 || (found > 0 && found < count)));
            CHECK(hits[count].t == -5);
            CHECK(any[count] == 7);
        }
    }
}

}  // namespace

TEST_CASE("rays in columns have the answers of the same rays in an array") {
    SceneBuilder b = everything();
    const ir::Scene scene = b.scene();
    renderer::PrepareOptions options;
    options.acceleration = Acceleration::kFast;
    const auto prepared = renderer::prepare<float>(scene, options);
    const auto middle = prepared.to_local({0, 2, 8});
    constexpr std::size_t kMost = 150;
    std::uint32_t state = 1;
    const auto random = [&state] {
        state = state * 1664525U + 1013904223U;
        return static_cast<float>(state >> 8U) / float(1U << 24U);
    };
    struct Numbers {
        std::array<float, kMost> x, y, z;
    } origin{}, direction{};
    std::array<float, kMost> t_max{}, time{};
    std::array<std::uint32_t, kMost> object{}, face{};
    std::array<std::int32_t, kMost> outward{};
    const auto about_0 = [&] { return random() - 0.5F; };
    for (std::size_t i = 0; i < kMost; ++i) {
        // Some go the other way, so that a packet ends before them.
        const float turn = i < 100 ? 1.0F : -1.0F;
        origin.x[i] = middle.x + 0.1F * about_0();
        origin.y[i] = middle.y + 0.1F * about_0();
        origin.z[i] = middle.z;
        direction.x[i] = turn * (0.3F + 0.5F * about_0());
        direction.y[i] = -0.25F + 0.4F * about_0();
        direction.z[i] = -1;
        t_max[i] = i % 3 == 0 ? 12 * (0.5F + about_0()) : std::numeric_limits<float>::infinity();
        time[i] = 0.5F + about_0();
        object[i] = i % 5 == 0 ? static_cast<std::uint32_t>(i % 6) : ir::ObjectId::kNone;
        outward[i] = i % 2 == 0 ? 0 : 1;
    }
    renderer::RayColumns<float> columns{
        {origin.x.data(), origin.y.data(), origin.z.data()},
        {direction.x.data(), direction.y.data(), direction.z.data()},
        false,
        t_max.data(),
        time.data(),
        object.data(),
        face.data(),
        outward.data()};
    for (const bool bounded : {true, false}) {
        if (!bounded) {
            columns.t_max = nullptr;
            columns.object = nullptr;
            columns.one_origin = true;
            origin.x.fill(middle.x);
            origin.y.fill(middle.y);
            origin.z.fill(middle.z);
        }
        for (const std::size_t first : {0U, 5U, 64U}) {
            for (const std::size_t count : {1U, 16U, 17U, 40U, 64U, 80U, 86U}) {
                const auto rest = columns.from(first);
                std::vector<renderer::Hit<float>> closest(count + 1), any(count + 1);
                closest[count].t = any[count].t = -5;
                renderer::Counters counters;
                renderer::closest_hits<float>(prepared, rest, std::span(closest).first(count),
                                              counters, renderer::Coherence::kCoherent);
                renderer::any_hits<float>(prepared, rest, std::span(any).first(count), counters,
                                          renderer::Coherence::kCoherent);
                for (std::size_t i = 0; i < count; ++i) {
                    const auto hit = closest_hit(prepared, rest.ray(i), rest.exclude(i), counters);
                    CHECK(any[i].object.valid() == hit.object.valid());
                    CHECK(closest[i].object == hit.object);
                    if (!hit) continue;
                    CHECK(closest[i].t == hit.t);
                    CHECK(closest[i].face == hit.face);
                    CHECK(closest[i].u == hit.u);
                    CHECK(closest[i].v == hit.v);
                }
                CHECK(closest[count].t == -5);
                CHECK(any[count].t == -5);
            }
        }
    }
}

TEST_CASE("a batch of rays has the answers of its rays") {
    SceneBuilder b = everything();
    check_batches<float>(b.scene());
    check_batches<double>(b.scene());
}

TEST_CASE("a batch that meets a triangle on its edge, before one that it met inside") {
    for (const bool edge_first : {false, true}) {
        SceneBuilder b;
        for (const bool edge : {edge_first, !edge_first}) {
            if (edge) {
                b.triangle({0.25, -1, -1}, {1, 0, -1}, {0.25, 1, -1});
            } else {
                b.triangle({-5, -5, -2}, {5, -5, -2}, {0, 5, -2});
            }
        }
        renderer::PrepareOptions options;
        options.acceleration = Acceleration::kFast;
        const auto prepared = renderer::prepare<float>(b.scene(), options);
        std::vector<renderer::Ray<float>> rays(64);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            rays[i].origin = prepared.to_local({0, 0, 0});
            // x is 0.25, exactly, where z is -1.
            rays[i].direction = {0.25F, 0.125F + static_cast<float>(i) / 512, -1};
        }
        const std::vector<renderer::Exclude> excludes(rays.size());
        std::vector<renderer::Hit<float>> hits(rays.size());
        renderer::Counters counters;
        renderer::closest_hits<float>(prepared, rays, excludes, hits, counters,
                                      renderer::Coherence::kCoherent);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto hit = closest_hit(prepared, rays[i], excludes[i], counters);
            CHECK(hit.t == 1);
            CHECK(hits[i].t == hit.t);
            CHECK(hits[i].object == hit.object);
        }
    }
}

TEST_CASE("pixels by blocks: each once, and neighbours together") {
    for (std::uint32_t width = 1; width <= 18; ++width) {
        for (std::uint32_t height = 1; height <= 18; ++height) {
            const renderer::Tile tile{5, 7, 5 + width, 7 + height};
            std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
            for (std::uint64_t i = 0; i < tile.pixels(); ++i) {
                const renderer::PixelPlace at = renderer::pixel_in_blocks(tile, i);
                CHECK((at.x >= tile.x0 && at.x < tile.x1 && at.y >= tile.y0 && at.y < tile.y1));
                CHECK(seen.insert({at.x, at.y}).second);
            }
        }
    }
    const renderer::Tile tile{0, 0, 32, 32};
    for (const std::uint32_t side : {2U, 4U, 8U}) {
        for (std::uint64_t i = 0; i < tile.pixels(); ++i) {
            const renderer::PixelPlace first =
                renderer::pixel_in_blocks(tile, i / (side * side) * side * side);
            const renderer::PixelPlace at = renderer::pixel_in_blocks(tile, i);
            CHECK(at.x - first.x < side);
            CHECK(at.y - first.y < side);
        }
    }
}

TEST_CASE("batches and single rays draw one picture, however deep the trees of rays") {
    SceneBuilder b = everything();
    renderer::Settings s = full(24, 18, 3);
    std::uint64_t refracted = 0;
    for (const auto precision : {renderer::Precision::kFloat, renderer::Precision::kDouble}) {
        s.precision = precision;
        for (s.bounces = 0; s.bounces <= 8; ++s.bounces) {
            CAPTURE(s.bounces);
            s.tile_size = 7 + 5 * s.bounces;
            const Rendered r = check_both(b.scene(), s, s.bounces % 3 + 1);
            refracted = r.stats.counters.refracted_rays;
            CHECK((refracted > 0) == (s.bounces > 0));
        }
    }
    CHECK(refracted > 1000);
}

TEST_CASE("batches and single rays draw one picture, of trees too big to be kept whole") {
    // Panes of glass between a ball and the camera: each sample has thousands of rays.
    SceneBuilder b;
    b.background({0.3, 0.5, 0.9});
    b.material({0.1, 0.2, 0.1}, {0.9, 0.8, 0.9}, 0, 1.5);
    for (int i = 0; i < 3; ++i) b.box({-50, -50, -2.0 * i - 1}, {50, 50, -2.0 * i});
    b.sphere({0.5, 0, -8}, 2);
    renderer::Settings s = settings(3, 2, 1);
    s.bounces = 19;
    const Rendered r = check_both(b.scene(), s, 2);
    CHECK(r.stats.counters.rays() > 500000);
}

TEST_CASE("trees too big to be kept whole, lit by a light with a size, put down at every stage") {
    // What a light draws hangs on the whole path, also where only its end was taken up again.
    SceneBuilder b;
    b.background({0.3, 0.5, 0.9});
    b.material({0.4, 0.5, 0.6}, {0.9, 0.8, 0.9}, 0, 1.5);
    for (int i = 0; i < 3; ++i) b.box({-50, -50, -2.0 * i - 1}, {50, 50, -2.0 * i});
    b.sphere({0.5, 0, -8}, 2);
    b.point_light({1, 2, 3}, {5, 5, 5}, 0.5);
    renderer::Settings s = settings(3, 3, 7);
    s.bounces = 16;
    s.acceleration = Acceleration::kBvh;
    const Rendered reference = render(b.scene(), s);
    s.acceleration = Acceleration::kFast;
    // Deadlines that are over before they begin.
    const Rendered fast = render(b.scene(), s, 1, -1);
    CHECK(same(reference.picture, fast.picture));
    CHECK(same_rays(reference.stats.counters, fast.stats.counters));
    // Of a run of 63 samples; several times as many as one tree may have.
    CHECK(reference.stats.counters.rays() - reference.stats.counters.shadow_rays > 200000);
    CHECK(reference.stats.counters.shadow_rays > 50000);
}

TEST_CASE("batches and single rays draw one picture, whatever is switched off") {
    SceneBuilder b = everything();
    renderer::Settings s = full(24, 18, 2);
    for (std::size_t i = 0; i < ir::kEffectCount; ++i) {
        CAPTURE(i);
        s.effects = without(all_effects(), static_cast<Effect>(i));
        check_both(b.scene(), s);
    }
    s.effects = effects({});
    CHECK(check_both(b.scene(), s).stats.counters.rays() == 24 * 18 * 2);
}

TEST_CASE("batches and single rays draw one picture, with one sample a pixel and with many") {
    SceneBuilder b = everything();
    for (const std::uint32_t samples : {0U, 1U, 2U, 127U, 300U}) {
        CAPTURE(samples);
        check_both(b.scene(), full(9, 5, samples));
    }
}

TEST_CASE("batches and single rays draw one picture, cut and shared out") {
    SceneBuilder b = everything();
    renderer::Settings s = full(50, 37, 2);
    s.crop = renderer::Crop{7, 11, 30, 37};
    s.tile_size = 16;
    check_both(b.scene(), s, 2);
    s.shard_count = 3;
    for (s.shard_index = 0; s.shard_index < 3; ++s.shard_index) check_both(b.scene(), s);
}

TEST_CASE("batches in scenes without light, and without anything to see") {
    SceneBuilder dark = everything();
    dark.scene().lights.clear();
    CHECK(check_both(dark.scene(), full(16, 12, 2)).stats.counters.shadow_rays == 0);
    SceneBuilder b = everything();
    b.camera({0, 50, 0}, {0, 1, 0}, 0.5);
    renderer::Settings s = full(16, 12, 2);
    s.acceleration = Acceleration::kBvh;
    const Rendered reference = render(b.scene(), s);
    s.acceleration = Acceleration::kFast;
    const Rendered fast = render(b.scene(), s);
    CHECK(same(reference.picture, fast.picture));
    CHECK(fast.stats.counters.rays() == 16 * 12 * 2);
}

TEST_CASE("the bad samples of a batch are those of single rays") {
    SceneBuilder b;
    b.background({0.25, 0.25, 0.25});
    b.sphere({0, 0, 0}, 1);
    b.sun({0, 0, -1}, {1e300, 1, 1});
    renderer::Settings s = full(33, 33, 4);
    for (const std::uint32_t tile : {8U, 33U}) {
        s.tile_size = tile;
        s.acceleration = Acceleration::kBvh;
        const Rendered reference = render(b.scene(), s);
        s.acceleration = Acceleration::kFast;
        const Rendered fast = render(b.scene(), s);
        CHECK(same(reference.picture, fast.picture));
        CHECK(reference.stats.bad_sample_count > 16);
        CHECK(reference.stats.bad_sample_count == fast.stats.bad_sample_count);
        REQUIRE(fast.stats.bad_samples.size() == 16);
        for (std::size_t i = 0; i < 16; ++i) {
            const renderer::BadSample& one = reference.stats.bad_samples[i];
            const renderer::BadSample& other = fast.stats.bad_samples[i];
            CHECK((!(one < other) && !(other < one)));
            CHECK(one.span == other.span);
        }
    }
}

TEST_CASE("a batch of rays that take long is put down in its middle") {
    // Thirty thousand spheres in one place: each ray is tested against most of them, and a whole
    // batch of such rays would outlast any deadline.
    constexpr std::uint32_t kSpheres = 30000;
    SceneBuilder b;
    b.background({1, 1, 1});
    for (std::uint32_t i = 0; i < kSpheres; ++i) b.sphere({0, 0, 1e-6 * i}, 2);
    b.point_light({0, 0, 20}, {1, 1, 1});
    const auto scheduler = renderer::make_serial_scheduler();
    const auto job = renderer::start_render(b.scene(), settings(16, 16, 1), *scheduler);
    std::uint64_t before = 0;
    std::uint64_t most = 0;
    std::uint64_t steps = 0;
    while (!job->step(soon(-1)).done) {
        const renderer::Counters counters = job->stats().counters;
        const std::uint64_t tests = counters.box_tests + counters.primitive_tests;
        most = std::max(most, tests - before);
        before = tests;
        ++steps;
    }
    CHECK(before > 200 * std::uint64_t{kSpheres});
    // Sixteen rays at once, and never more: those of a step are tested against all there is.
    CHECK(steps >= job->stats().counters.rays() / 16);
    CHECK(most <= 16 * 2 * std::uint64_t{kSpheres});
}
