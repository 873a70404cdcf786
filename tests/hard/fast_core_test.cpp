// SPDX-License-Identifier: MIT
// The fast core against brute force, bit for bit: one ray at a time and in batches, by every
// instruction set of this processor, in float and in double.
#include <doctest/doctest.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "renderer/intersect/batch.hpp"
#include "renderer/intersect/instruction_set.hpp"
#include "tests/hard/mixed.hpp"
#include "tests/support/with_instruction_set.hpp"

namespace cobble::test {

namespace {

template <typename T>
struct Questions {
    std::vector<renderer::Ray<T>> rays;
    std::vector<renderer::Exclude> excludes;
    std::vector<renderer::Hit<T>> answers;  ///< of brute force

    void ask(const renderer::PreparedScene<T>& reference, const renderer::Ray<T>& r,
             const renderer::Exclude& exclude) {
        renderer::Counters counters;
        rays.push_back(r);
        excludes.push_back(exclude);
        answers.push_back(closest_hit_brute_force(reference, r, exclude, counters));
    }
};

/// Every kind of ray, and onward from each hit.
template <typename T>
Questions<T> mixed_questions(const renderer::PreparedScene<T>& reference, std::uint64_t seed,
                             int count) {
    Questions<T> q;
    Random random(seed + 100);
    for (int i = 0; i < count; ++i) {
        const auto r = any_ray<T>(random);
        q.ask(reference, r, {});
        const auto hit = q.answers.back();
        if (!hit) continue;
        const auto s = renderer::surface_at(reference, r, hit);
        const auto next = renderer::leave(s, random.direction().template to<T>(), r.time);
        q.ask(reference, next.ray, next.exclude);
    }
    return q;
}

/// Bundles of 64 from one eye, or toward one point, and half a bundle at the end.
template <typename T>
Questions<T> bundles(const renderer::PreparedScene<T>& reference, std::uint64_t seed, int count) {
    Questions<T> q;
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
            q.ask(reference, r, {});
        }
    }
    return q;
}

template <typename T>
void check(const ir::Scene& scene, const Questions<T>& q) {
    renderer::PrepareOptions options;
    options.acceleration = renderer::Acceleration::kFast;
    const auto fast = renderer::prepare<T>(scene, options);
    const auto rays = std::span<const renderer::Ray<T>>(q.rays);
    const auto excludes = std::span<const renderer::Exclude>(q.excludes);
    for (const std::string& name : renderer::instruction_sets()) {
        CAPTURE(name);
        const WithInstructionSet with(name);
        renderer::Counters counters;
        int single = 0;
        for (std::size_t i = 0; i < q.rays.size(); ++i) {
            const auto hit = closest_hit(fast, q.rays[i], q.excludes[i], counters);
            const bool any = any_hit(fast, q.rays[i], q.excludes[i], counters);
            if (!same(hit, q.answers[i]) || any != q.answers[i].object.valid()) ++single;
        }
        CHECK(single == 0);
        for (const auto coherence : {renderer::Coherence::kNone, renderer::Coherence::kCoherent}) {
            std::vector<renderer::Hit<T>> hits(q.rays.size());
            std::vector<std::uint8_t> any(q.rays.size());
            closest_hits(fast, rays, excludes, std::span(hits), counters, coherence);
            any_hits(fast, rays, excludes, std::span(any), counters, coherence);
            int batched = 0;
            for (std::size_t i = 0; i < hits.size(); ++i) {
                if (!same(hits[i], q.answers[i])) ++batched;
                if ((any[i] != 0) != q.answers[i].object.valid()) ++batched;
            }
            CHECK(batched == 0);
        }
    }
}

template <typename T>
void compare(int rays, int bundle_count) {
    std::size_t hits = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const ir::Scene scene = mixed_scene(seed);
        const auto reference = renderer::prepare<T>(scene);
        const auto mixed = mixed_questions(reference, seed, rays);
        check(scene, mixed);
        check(scene, bundles(reference, seed, bundle_count));
        for (const auto& hit : mixed.answers) hits += hit.object.valid() ? 1 : 0;
    }
    CHECK(hits > static_cast<std::size_t>(rays));
}

}  // namespace

TEST_CASE("there is always an instruction set, and an unknown one changes nothing") {
    CHECK_FALSE(renderer::instruction_sets().empty());
    CHECK_FALSE(renderer::use_instruction_set("abacus"));
    CHECK(renderer::use_instruction_set(""));
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
    const auto reference = renderer::prepare<float>(make.scene);
    Questions<float> q;
    for (int i = 0; i < 64 * 30; ++i) {
        const auto& v = spots[random.below(static_cast<std::uint32_t>(spots.size()))];
        const double a = i % 3 == 0 ? 0 : random.unit();
        const double b = i % 5 == 0 ? 1 - a : random.in(0, 1 - a);
        const Vec3d target = v[0] + (v[1] - v[0]) * a + (v[2] - v[0]) * b;
        const Vec3d from{0, 0, 8};
        q.ask(reference, ray<float>(from, target - from), {});
    }
    check(make.scene, q);
}

}  // namespace cobble::test
