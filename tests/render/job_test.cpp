// SPDX-License-Identifier: MIT
// The job: progress, deadlines, cancelling, and samples that came out as no numbers.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/render/scene_builder.hpp"

using namespace cobble;
using namespace cobble::test;

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Two panes of glass face to face: with many bounces a single sample takes longer than any step.
SceneBuilder endless() {
    SceneBuilder b;
    b.background({1, 1, 1});
    b.material({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, 0, 1.5);
    for (int i = 0; i < 8; ++i) b.box({-50, -50, -2.0 * i - 1}, {50, 50, -2.0 * i});
    return b;
}

}  // namespace

TEST_CASE("progress runs from nothing to all, and done means complete") {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1);
    const auto scheduler = renderer::make_thread_scheduler(2);
    const auto job = renderer::start_render(b.scene(), settings(64, 64, 16), *scheduler);
    CHECK_FALSE(job->picture().complete);
    double last = 0;
    renderer::Progress progress;
    do {
        progress = job->step(soon(-1));
        CHECK(progress.fraction >= last);
        last = progress.fraction;
        CHECK(progress.fraction <= 1);
    } while (!progress.done);
    CHECK(progress.fraction == 1);
    CHECK(progress.rays == 64 * 64 * 16);
    CHECK(progress.seconds > 0);
    CHECK(job->picture().complete);
    CHECK(job->stats().phases.size() == 2);
    CHECK(job->stats().scene_bytes > 0);
    // More steps change nothing.
    CHECK(job->step(soon(10)).done);
    CHECK(job->stats().counters.camera_rays == 64 * 64 * 16);
}

TEST_CASE("steps keep their deadlines even where one sample outlasts them") {
    SceneBuilder b = endless();
    renderer::Settings s = settings(4, 4, 1);
    s.bounces = 40;
    for (const std::uint32_t threads : {1U, 3U}) {
        const auto scheduler = renderer::make_thread_scheduler(threads);
        const auto job = renderer::start_render(b.scene(), s, *scheduler);
        std::vector<double> spent;
        // Preparing is no step's work: on a busy machine it may outlast several.
        std::uint64_t rays = 0;
        while (rays == 0) rays = job->step(soon(10)).rays;
        const std::uint64_t first = rays;
        for (int i = 0; i < 15; ++i) {
            const std::clock_t before = std::clock();
            const renderer::Progress progress = job->step(soon(10));
            spent.push_back(1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
            REQUIRE_FALSE(progress.done);
            CHECK(progress.rays >= rays);
            rays = progress.rays;
        }
        // Of single steps a busy machine may keep the workers from all.
        CHECK(rays > first);
        // In time of the processor, of all workers: on a busy machine the clock on the wall also
        // counts what other programs take.
        CHECK(*std::max_element(spent.begin(), spent.end()) <= threads * 20.0);
    }
}

TEST_CASE("cancelling from another thread ends a long step soon") {
    SceneBuilder b = endless();
    renderer::Settings s = settings(64, 64, 1);
    s.bounces = 40;
    const auto scheduler = renderer::make_thread_scheduler(2);
    // The best of a few: a busy machine may not let us look at the clock in time.
    double took = 1e9;
    for (int attempt = 0; attempt < 5 && took > 100; ++attempt) {
        const auto job = renderer::start_render(b.scene(), s, *scheduler);
        Clock::time_point cancelled;
        std::thread other([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            cancelled = Clock::now();
            job->cancel();
        });
        const renderer::Progress progress = job->step(soon(60000));
        const auto ended = Clock::now();
        other.join();
        took = std::chrono::duration<double, std::milli>(ended - cancelled).count();
        CHECK(progress.done);
        CHECK(progress.fraction < 1);
        CHECK_FALSE(job->picture().complete);
        CHECK(job->step(soon(1000)).done);
    }
    CHECK(took <= 100);
}

TEST_CASE("preparing a large scene neither holds up a step nor a cancel") {
    // Half a million triangles: a few hundred milliseconds of building a tree.
    ir::Mesh mesh;
    const std::uint32_t n = 500;
    for (std::uint32_t i = 0; i <= n; ++i) {
        for (std::uint32_t k = 0; k <= n; ++k) {
            mesh.positions.push_back({i * 0.01, std::sin(i * 0.05) * std::cos(k * 0.03), k * 0.01});
        }
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t k = 0; k < n; ++k) {
            const std::uint32_t at = i * (n + 1) + k;
            const auto corner = [](std::uint32_t p) {
                return ir::Mesh::Corner{p, ir::Mesh::kNone, ir::Mesh::kNone};
            };
            mesh.faces.push_back({{corner(at), corner(at + 1), corner(at + n + 1)}});
            mesh.faces.push_back({{corner(at + 1), corner(at + n + 2), corner(at + n + 1)}});
        }
    }
    mesh.face_offsets.assign(mesh.faces.size(), 0);
    SceneBuilder b;
    b.mesh(std::move(mesh));
    const auto scheduler = renderer::make_thread_scheduler(2);
    double abandoned = 0;
    {
        auto job = renderer::start_render(b.scene(), settings(64, 64, 1), *scheduler);
        // One step that is in time will do: a busy machine holds up the others.
        bool in_time = false;
        std::uint64_t rays = 0;
        while (!in_time && rays == 0) {
            const auto deadline = soon(2);
            rays = job->step(deadline).rays;
            in_time = milliseconds_since(deadline) <= 10;
        }
        CHECK(in_time);
        CHECK(rays == 0);
        CHECK(job->stats().scene_bytes == 0);
        const auto begun = Clock::now();
        job->cancel();
        CHECK(job->step(soon(1000)).done);
        job.reset();
        abandoned = milliseconds_since(begun);
    }
    const auto again = Clock::now();
    CHECK(render(b.scene(), settings(8, 8, 1), 2).picture.complete);
    // Given up long before it would have been ready.
    CHECK(abandoned < milliseconds_since(again));
}

TEST_CASE("without threads the scene is prepared in a step of its own") {
    SceneBuilder b;
    b.sphere({0, 0, 0}, 1);
    const auto scheduler = renderer::make_serial_scheduler();
    const auto job = renderer::start_render(b.scene(), settings(64, 64, 4), *scheduler);
    CHECK(job->step(soon(0)).rays == 0);
    CHECK(job->stats().scene_bytes > 0);
    CHECK(job->step(soon(0)).rays > 0);
}

TEST_CASE("a cancelled picture keeps the pixels that were finished") {
    SceneBuilder b;
    b.background({0.5, 0.5, 0.5});
    renderer::Settings s = settings(256, 256, 64);
    s.want_sample_count = true;
    s.tile_size = 16;
    const auto scheduler = renderer::make_serial_scheduler();
    const auto job = renderer::start_render(b.scene(), s, *scheduler);
    renderer::Progress progress;
    do progress = job->step(soon(0));
    while (progress.fraction < 0.05);
    job->cancel();
    const renderer::Picture picture = job->picture();
    REQUIRE_FALSE(picture.complete);
    std::uint32_t finished = 0;
    for (std::uint32_t y = 0; y < 256; ++y) {
        for (std::uint32_t x = 0; x < 256; ++x) {
            const float count = picture.sample_count.at(x, y, 0);
            const bool whole = count == 64 && picture.color.at(x, y, 0) == 0.5F;
            const bool empty = count == 0 && picture.color.at(x, y, 0) == 0;
            REQUIRE((whole || empty));
            finished += whole ? 1 : 0;
        }
    }
    CHECK(finished > 0);
    CHECK(finished < 256 * 256);
}

TEST_CASE("row 40: samples that are no numbers are counted, located and left out") {
    // Too bright for a float: infinity on the sphere, in single precision only.
    SceneBuilder b;
    b.background({0.25, 0.25, 0.25});
    b.sphere({0, 0, 0}, 1);
    b.scene().objects[0].span.source.value = 3;
    b.sun({0, 0, -1}, {1e300, 1, 1});
    renderer::Settings s = settings(33, 33, 4);
    s.want_sample_count = true;
    s.tile_size = 8;
    const Rendered r = render(b.scene(), s, 3);
    CHECK(r.stats.bad_sample_count > 0);
    REQUIRE(r.stats.bad_samples.size() == 16);
    const auto before = [](const renderer::BadSample& a, const renderer::BadSample& c) {
        return std::tie(a.y, a.x, a.sample) < std::tie(c.y, c.x, c.sample);
    };
    CHECK(std::is_sorted(r.stats.bad_samples.begin(), r.stats.bad_samples.end(), before));
    CHECK(r.stats.bad_samples[0].span == b.scene().objects[0].span);
    double missing = 0;
    for (std::uint32_t y = 0; y < 33; ++y) {
        for (std::uint32_t x = 0; x < 33; ++x) {
            missing += 4 - static_cast<double>(r.picture.sample_count.at(x, y, 0));
            CHECK(std::isfinite(r.color(x, y).x));
            // Pixels on the edge have the colour of the samples that count.
            if (r.picture.sample_count.at(x, y, 0) > 0) CHECK(r.color(x, y).x == 0.25F);
        }
    }
    CHECK(missing == static_cast<double>(r.stats.bad_sample_count));
    // The first ones of the picture, whatever the tiles and threads.
    s.tile_size = 64;
    const Rendered other = render(b.scene(), s);
    CHECK(other.stats.bad_sample_count == r.stats.bad_sample_count);
    for (std::size_t i = 0; i < 16; ++i) {
        CHECK(other.stats.bad_samples[i].x == r.stats.bad_samples[i].x);
        CHECK(other.stats.bad_samples[i].y == r.stats.bad_samples[i].y);
        CHECK(other.stats.bad_samples[i].sample == r.stats.bad_samples[i].sample);
    }
    // A double holds it.
    s.precision = renderer::Precision::kDouble;
    CHECK(render(b.scene(), s).stats.bad_sample_count == 0);
}

TEST_CASE("sizes at the ends of their ranges") {
    SceneBuilder b;
    b.background({0.5, 0.5, 0.5});
    for (const auto& [width, height] : {std::pair{1U, 1U}, {1U, 500U}, {500U, 1U}, {0U, 5U}}) {
        renderer::Settings s = settings(width, height, 0);
        s.tile_size = 0;
        const Rendered r = render(b.scene(), s, 2);
        CHECK(r.picture.complete);
        CHECK(r.stats.counters.camera_rays == std::uint64_t{width} * height);
    }
}
