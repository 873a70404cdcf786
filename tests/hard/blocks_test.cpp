// SPDX-License-Identifier: MIT
// Worlds of blocks: rows 23 and 24 of the hard cases.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "tests/hard/cores.hpp"
#include "tests/hard/lattice.hpp"
#include "tests/hard/wrong_shapes.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

/// Through corners, edges and faces of the lattice, along axes and diagonals, from outside, from
/// faces and from within blocks.
LatticeRay lattice_ray(Random& random, std::int64_t side) {
    LatticeRay r{};
    const auto kind = random.below(5);
    do {
        for (std::size_t i = 0; i < 3; ++i) {
            // On planes of the lattice, or half or a quarter of a cell off them.
            const auto step = kind < 3 ? 4 : kind == 3 ? 2 : 1;
            const auto places = static_cast<std::uint32_t>(4 * (side + 8) / step);
            r.origin[i] = static_cast<std::int64_t>(random.below(places)) * step - 16;
            const auto most = kind == 0 ? 1U : kind == 1 ? 3U : 40U;
            r.direction[i] = static_cast<std::int64_t>(random.below(2 * most + 1)) - most;
            if (random.below(6) == 0) r.direction[i] = 0;
        }
    } while (r.direction == Cell{});
    return r;
}

/// The ray in numbers of T, which hold it exactly; 0 of either sign.
template <typename T>
renderer::Ray<T> in_numbers(const LatticeRay& r, Random& random) {
    renderer::Ray<T> ray;
    for (std::size_t i = 0; i < 3; ++i) {
        ray.origin[i] = static_cast<T>(r.origin[i]) / 4;
        ray.direction[i] = static_cast<T>(r.direction[i]);
        if (r.direction[i] == 0) ray.direction[i] = random.below(2) == 0 ? T(0) : T(-0.0);
    }
    return ray;
}

template <typename T>
bool near_ratio(T t, Ratio exact) {
    // (bound - origin) is exact; its product with a rounded inverse, and that, make two roundings.
    return std::fabs(double{t} - exact.value()) <=
           2.5 * double{renderer::kRounding<T>} * std::fabs(exact.value());
}

/// Whether hits, each block's two ends, are those of the walk in its order; where exact distances
/// are equal any order will do.
template <typename T>
bool is_walk(const std::vector<Visit>& visits, const std::vector<renderer::Hit<T>>& hits) {
    std::map<std::uint32_t, Visit> due;
    std::size_t ends = 0;
    for (const Visit& v : visits) {
        due[v.object] = v;
        ends += v.enters.n > 0 ? 2U : 1U;
    }
    if (hits.size() != ends) return false;
    std::map<std::uint32_t, int> seen;
    Ratio last{0, 1};
    for (const auto& hit : hits) {
        const auto found = due.find(hit.object.value);
        if (found == due.end()) return false;
        const Visit& v = found->second;
        const bool enters = v.enters.n > 0 && seen[hit.object.value]++ == 0;
        const Ratio t = enters ? v.enters : v.leaves;
        if (!near_ratio(hit.t, t) || t < last) return false;
        last = t;
    }
    return true;
}

struct Walks {
    int steps = 0;   ///< cells looked at
    int visits = 0;  ///< blocks met
    int wrong = 0;   ///< rays whose hits in order are not the walk
    int first_wrong = 0;
};

/// `cast` answers the nearest hit.
template <typename T, typename Cast>
Walks walk_blocks(int rays, Cast cast) {
    Walks result;
    Random random(23);
    for (const double filled : {0.1, 0.5, 1.0}) {
        const BlockWorld world = block_world(9, filled, {}, 23);
        Questions<T> cores(world.scene);
        const auto& scene = cores.reference;
        REQUIRE(scene.origin == Vec3d{});
        for (int i = 0; i < rays; ++i) {
            const LatticeRay exact = lattice_ray(random, world.side);
            renderer::Ray<T> r = in_numbers<T>(exact, random);
            const auto visits = walk_lattice(world, exact, result.steps);
            result.visits += static_cast<int>(visits.size());
            if (!is_walk(visits, renderer::enumerate_hits(scene, r))) ++result.wrong;
            // The nearest: whichever of those at the least distance, from outside or from within.
            const renderer::Hit<T> first = cast(scene, r);
            bool right = first.object.valid() == !visits.empty();
            if (right && first) {
                Ratio least = visits[0].leaves;
                for (const Visit& v : visits)
                    least = std::min(least, v.enters.n > 0 ? v.enters : v.leaves);
                bool there = false;
                for (const Visit& v : visits) {
                    const Ratio t = v.enters.n > 0 ? v.enters : v.leaves;
                    there = there || (v.object == first.object.value && t == least);
                }
                right = there && near_ratio(first.t, least);
            }
            result.first_wrong += right ? 0 : 1;
            // And on through the world, by all cores.
            for (int hop = 0; hop < 3; ++hop) {
                const auto hit = cores.ask(r);
                if (!hit) break;
                r.t_min = hit.t;
            }
        }
        CHECK(cores.differences() == "");
    }
    return result;
}

}  // namespace

TEST_CASE("row 23: the blocks that a ray meets in order are those of a walk in whole numbers") {
    const Walks f = walk_blocks<float>(4000, kByTree);
    const Walks d = walk_blocks<double>(600, kByTree);
    CHECK(f.steps + d.steps > 50000);
    CHECK(f.visits > 10000);
    CHECK(f.wrong == 0);
    CHECK(d.wrong == 0);
    record(23, counted(f.wrong + d.wrong) + " of 13,800 rays unlike the walk, " +
                   counted(f.visits + d.visits) + " blocks met");
    CHECK(f.first_wrong == 0);
    CHECK(d.first_wrong == 0);
}

TEST_CASE("row 23: slabs that multiply 0 by infinity, and rough reciprocals, lose the way") {
    Kernels wrong;
    CHECK(walk_blocks<float>(100, wrong).first_wrong == 0);
    wrong.box = nan_slabs;
    CHECK(walk_blocks<float>(100, wrong).first_wrong > 0);
    wrong.box = rough_reciprocal;
    CHECK(walk_blocks<float>(100, wrong).first_wrong > 0);
}

namespace {

/// The edge of a famous game's world.
const Vec3d kBorder{30000000, 64, -30000000};

/// A world of blocks around `corner`, and the camera near it.
ir::Scene world_at(Vec3d corner) {
    BlockWorld world = block_world(10, 0.3, corner, 24);
    world.scene.camera.center = corner + Vec3d{5.5, 4.25, 14};
    return world.scene;
}

struct Compared {
    int hits = 0;
    int differ = 0;  ///< in t, object, face or normal, or by more than `slack` in u or v
};

/// The same rays, `by` apart, into two worlds that are as far apart.
template <typename T>
Compared compare_worlds(const ir::Scene& near, const ir::Scene& far, Vec3d by, int rays,
                        double slack) {
    const auto a = renderer::prepare<T>(near);
    Questions<T> cores(far);
    const auto& b = cores.reference;
    renderer::Counters counters;
    Random random(24);
    Compared result;
    for (int i = 0; i < rays; ++i) {
        // Numbers that stay what they are however they are moved.
        const auto coarse = [&](Vec3d p) {
            return Vec3d{std::floor(p.x * 64) / 64, std::floor(p.y * 64) / 64,
                         std::floor(p.z * 64) / 64};
        };
        const Vec3d from = coarse(Vec3d{5, 5, 5} + random.direction() * 12);
        renderer::Ray<T> r =
            ray<T>(from - a.origin, coarse(random.point(3) + Vec3d{5, 5, 5}) - from);
        renderer::Ray<T> moved = r;
        moved.origin = b.to_local(from + by);
        const auto p = closest_hit(a, r, {}, counters);
        const auto q = cores.ask(moved);
        result.hits += p ? 1 : 0;
        bool equal = same(p, q);
        if (equal && p) {
            const auto s = surface_at(a, r, p);
            const auto t = surface_at(b, moved, q);
            equal = s.geometric_normal == t.geometric_normal &&
                    std::fabs(double{s.uv.x} - double{t.uv.x}) <= slack &&
                    std::fabs(double{s.uv.y} - double{t.uv.y}) <= slack;
        }
        result.differ += equal ? 0 : 1;
    }
    CHECK(cores.differences() == "");
    return result;
}

}  // namespace

TEST_CASE("row 24: a world of blocks 30,000,000 away is the one at zero to the bit") {
    // By whole steps of the grid that coordinates are counted from nothing changes; by other whole
    // numbers hits are the same, and where on a face they are is a matter of its last digits.
    const std::pair<Vec3d, double> moves[] = {{kBorder, 0}, {kBorder + Vec3d{1, -1, 3}, 0x1p-23}};
    for (const auto& [by, slack] : moves) {
        const Compared f = compare_worlds<float>(world_at({}), world_at(by), by, 2000, slack);
        const Compared d = compare_worlds<double>(world_at({}), world_at(by), by, 400, slack);
        CHECK(f.hits > 1000);
        CHECK(f.differ == 0);
        CHECK(d.hits > 200);
        CHECK(d.differ == 0);
        record(24, counted(f.differ + d.differ) + " of " + counted(f.hits + d.hits) +
                       " hits differ" + (slack == 0 ? " at all" : ", moved off the grid"));
    }
}

TEST_CASE("row 24: a world too wide for float is noted, and right in double") {
    // A block at zero, where the camera is, keeps the coordinates from being brought near.
    const auto wide = [](Vec3d corner) {
        SceneMaker both;
        both.scene = world_at(corner);
        both.box({-1, -1, -1}, {0, 0, 0});
        both.scene.camera.center = {0, 0, 5};
        return both.scene;
    };
    const ir::Scene far = wide(kBorder);
    CHECK(renderer::prepare<double>(far).notes.empty());
    CHECK(compare_worlds<double>(world_at({}), far, kBorder, 400, 0x1p-23).differ == 0);
    CHECK(!renderer::prepare<float>(far).notes.empty());
    CHECK(compare_worlds<float>(world_at({}), far, kBorder, 400, 0x1p-23).differ > 100);
}

TEST_CASE("row 24: blocks near the camera are right in float, whatever lies far away") {
    SceneMaker both;
    both.scene = world_at(kBorder);
    both.box({-1, -1, -1}, {0, 0, 0});
    both.scene.camera.center = kBorder + Vec3d{4, 8, 4};
    // The far one is told of: a block is as wide as half a step there.
    CHECK(renderer::prepare<float>(both.scene).notes.size() == 1);
    const Compared near = compare_worlds<float>(world_at({}), both.scene, kBorder, 2000, 0x1p-16);
    CHECK(near.hits > 1000);
    CHECK(near.differ == 0);
}

}  // namespace cobble::test
