// SPDX-License-Identifier: MIT
// The fast core against brute force, bit for bit: one ray at a time and in batches, by every
// instruction set of this processor, in float and in double.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "renderer/intersect/batch.hpp"
#include "renderer/intersect/instruction_set.hpp"
#include "renderer/wide/wide.hpp"
#include "tests/hard/cores.hpp"
#include "tests/hard/mixed.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

/// Every kind of ray, and onward from each hit.
template <typename T>
void ask_mixed(Questions<T>& q, std::uint64_t seed, int count) {
    Random random(seed + 100);
    for (int i = 0; i < count; ++i) {
        const auto r = any_ray<T>(random);
        const auto hit = q.ask(r);
        if (!hit) continue;
        const auto s = renderer::surface_at(q.reference, r, hit);
        const auto next = renderer::leave(s, random.direction().template to<T>(), r.time);
        q.ask(next.ray, next.exclude);
    }
}

/// Bundles of 64 from one eye, or toward one point, and half a bundle at the end.
template <typename T>
void ask_bundles(Questions<T>& q, std::uint64_t seed, int count) {
    Random random(seed + 200);
    for (int bundle = 0; bundle < count; ++bundle) {
        const Vec3d eye = random.point(8);
        const Vec3d at = random.point(2);
        const double spread = bundle % 3 == 0 ? 0 : random.in(0.01, 1);
        const bool back = bundle % 2 == 0;
        const double time = random.unit();
        const int size = bundle + 1 == count ? 37 : 64;
        for (int i = 0; i < size; ++i) {
            const Vec3d target = at + random.point(spread);
            renderer::Ray<T> r = back ? ray<T>(target, eye - target) : ray<T>(eye, target - eye);
            r.time = static_cast<T>(time);
            if (back) r.t_max = 1;
            q.ask(r);
        }
    }
}

template <typename T>
void compare(int rays, int bundle_count) {
    std::size_t hits = 0;
    std::size_t asked = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        // Without boxes single rays take another walk.
        const ir::Scene scene = mixed_scene(seed, seed <= 4);
        Questions<T> mixed(scene);
        ask_mixed(mixed, seed, rays);
        CHECK(mixed.differences() == "");
        Questions<T> bundles(scene);
        ask_bundles(bundles, seed, bundle_count);
        CHECK(bundles.differences() == "");
        asked += mixed.rays.size() + bundles.rays.size();
        for (const auto& hit : mixed.answers) hits += hit.object.valid() ? 1 : 0;
    }
    CHECK(hits > static_cast<std::size_t>(rays));
    record(6, "0 of " + counted(static_cast<std::int64_t>(asked)) +
                  " rays differ by any instruction set, " + name_of_type<T>());
}

}  // namespace

TEST_CASE("there is always an instruction set, and an unknown one changes nothing") {
    CHECK_FALSE(renderer::instruction_sets().empty());
    CHECK_FALSE(renderer::use_instruction_set("abacus"));
    CHECK(renderer::use_instruction_set(""));
}

TEST_CASE("so many coherent rays are a packet, and one fewer are none") {
    const bool lanes = renderer::instruction_sets().front() != "scalar";
    SceneMaker make;
    make.sphere({0, 0, 0}, 1);
    renderer::PrepareOptions options;
    options.acceleration = renderer::Acceleration::kFast;
    const auto scene = renderer::prepare<float>(make.scene, options);
    const auto packet_rays = [&](std::size_t count) {
        const std::vector<renderer::Ray<float>> rays(count,
                                                     ray<float>({1, 2, 9}, {-0.1, -0.2, -1}));
        const std::vector<renderer::Exclude> excludes(count);
        std::vector<renderer::Hit<float>> hits(count);
        renderer::Counters counters;
        closest_hits(scene, std::span(rays), std::span(excludes), std::span(hits), counters,
                     renderer::Coherence::kCoherent);
        return counters.packet_rays;
    };
    constexpr std::size_t kFew = renderer::kFewestTogether;
    CHECK(packet_rays(kFew - 1) == 0);
    CHECK(packet_rays(kFew) == (lanes ? kFew : 0));
    // Two packets, and too few for a third.
    CHECK(packet_rays(128 + kFew - 1) == (lanes ? 128 : 0));
}

TEST_CASE(
    "packets among things far smaller than what is between their rays are given up, rightly") {
    const bool lanes = renderer::instruction_sets().front() != "scalar";
    // Eight by eight rays with 0.05 between them, through a cloud.
    const auto ask_of_boxes = [&](int count, double size) {
        SceneMaker make;
        Random random(77);
        make.plane({0, 0, 1}, -3);
        for (int i = 0; i < count; ++i) {
            const Vec3d at = random.point(0.3);
            make.box(at, at + Vec3d{size, size, size});
        }
        Questions<float> q(make.scene);
        for (int i = 0; i < 64 * 8; ++i) {
            const Vec3d across{0.05 * (i % 8) - 0.19, 0.05 * (i / 8 % 8) - 0.19, 0};
            q.ask(ray<float>({0.2 + 0.001 * (i / 64), 0.2, 4}, across - Vec3d{0.2, 0.2, 4}));
        }
        CHECK(q.differences() == "");
        std::vector<renderer::Hit<float>> hits(64);
        renderer::Counters counters;
        closest_hits(q.fast, std::span<const renderer::Ray<float>>(q.rays).first(64),
                     std::span<const renderer::Exclude>(q.excludes).first(64), std::span(hits),
                     counters, renderer::Coherence::kCoherent);
        return counters.packet_rays;
    };
    CHECK(ask_of_boxes(6000, 0.0005) == 0);
    CHECK(ask_of_boxes(60, 0.1) == (lanes ? 64 : 0));
}

TEST_CASE("an answer that differs in its last bit is told of every core") {
    SceneMaker make;
    make.sphere({0, 0, 0}, 1);
    Questions<float> q(make.scene);
    q.ask(ray<float>({0, 0, 5}, {0, 0, -1}));
    CHECK(q.differences() == "");
    q.answers[0].t = std::nextafter(q.answers[0].t, 9.0F);
    std::string expected = "tree: 1 of 1; ";
    for (const std::string& name : renderer::instruction_sets()) {
        expected +=
            name + ": 1 of 1; " + name + " in batches: 1 of 1; " + name + " in packets: 1 of 1; ";
    }
    CHECK(q.differences() == expected);
}

TEST_CASE("row 6: the fast core equals brute force bit for bit, float") {
    compare<float>(3000, 20);
}
TEST_CASE("row 6: the fast core equals brute force bit for bit, double") {
    compare<double>(600, 4);
}

TEST_CASE("row 7: the fast core gives a tie to the same triangle as brute force") {
    // Triangles on the same spot, many more than one block holds, in both windings; rays at their
    // edges, vertices and insides.
    SceneMaker make;
    Random random(9);
    std::vector<std::array<Vec3d, 3>> spots;
    for (int i = 0; i < 12; ++i) {
        const Vec3d at = random.point(2);
        spots.push_back({at, at + random.point(1), at + random.point(1)});
    }
    for (int copy = 0; copy < 9; ++copy) {
        for (const auto& v : spots) {
            make.triangle(v[0], v[copy % 2 == 0 ? 1 : 2], v[copy % 2 == 0 ? 2 : 1]);
        }
    }
    Questions<float> q(make.scene);
    for (int i = 0; i < 64 * 30; ++i) {
        const auto& v = spots[random.below(static_cast<std::uint32_t>(spots.size()))];
        const double a = i % 3 == 0 ? 0 : random.unit();
        const double b = i % 5 == 0 ? 1 - a : random.in(0, 1 - a);
        const Vec3d target = v[0] + (v[1] - v[0]) * a + (v[2] - v[0]) * b;
        const Vec3d from{0, 0, 8};
        q.ask(ray<float>(from, target - from));
    }
    CHECK(q.differences() == "");
}

}  // namespace cobble::test
