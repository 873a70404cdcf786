// SPDX-License-Identifier: MIT
// The tree against brute force, bit for bit, over scenes that mix everything.
#include <doctest/doctest.h>

#include "tests/hard/mixed.hpp"
#include "tests/hard/scenes.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

template <typename T>
void compare(int rays_a_scene) {
    int hits = 0;
    int differences = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const ir::Scene scene = mixed_scene(seed);
        const auto prepared = renderer::prepare<T>(scene);
        Random random(seed + 100);
        for (int i = 0; i < rays_a_scene; ++i) {
            const auto r = any_ray<T>(random);
            renderer::Hit<T> hit;
            if (!tree_agrees(prepared, r, {}, &hit)) ++differences;
            if (!hit) continue;
            ++hits;
            // And on from there, as shading would.
            const auto s = renderer::surface_at(prepared, r, hit);
            const auto next = renderer::leave(s, random.direction().to<T>(), r.time);
            if (!tree_agrees(prepared, next.ray, next.exclude)) ++differences;
        }
    }
    CHECK(differences == 0);
    CHECK(hits > rays_a_scene);
    record(6, counted(differences) + " of " + counted(6 * rays_a_scene + hits) +
                  " rays differ by the tree, " + name_of_type<T>());
}

}  // namespace

TEST_CASE("row 6: the tree equals brute force bit for bit, float") { compare<float>(10000); }
TEST_CASE("row 6: the tree equals brute force bit for bit, double") { compare<double>(2000); }

}  // namespace cobble::test
