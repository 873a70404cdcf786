// SPDX-License-Identifier: MIT
#include "tests/hard/lattice.hpp"

#include <algorithm>
#include <cstddef>

namespace cobble::test {

namespace {

constexpr std::int64_t kQuarters = 4;

std::int64_t floor_quarters(std::int64_t quarters) {
    return quarters >= 0 ? quarters / kQuarters : -((kQuarters - 1 - quarters) / kQuarters);
}

/// t where the ray crosses the plane `at` of an axis that it is not parallel to.
Ratio crossing(const LatticeRay& ray, std::size_t axis, std::int64_t at) {
    Ratio t{kQuarters * at - ray.origin[axis], kQuarters * ray.direction[axis]};
    if (t.d < 0) t = {-t.n, -t.d};
    return t;
}

/// Keeps the block of a cell that the ray is known to touch.
void visit(const BlockWorld& world, const LatticeRay& ray, Cell cell, std::vector<Visit>& visits) {
    const std::uint32_t object = world.at(cell);
    if (object == BlockWorld::kNone) return;
    bool first = true;
    Visit v{object, {}, {}};
    for (std::size_t i = 0; i < 3; ++i) {
        if (ray.direction[i] == 0) continue;
        const bool back = ray.direction[i] < 0;
        const Ratio in = crossing(ray, i, cell[i] + (back ? 1 : 0));
        const Ratio out = crossing(ray, i, cell[i] + (back ? 0 : 1));
        if (first || v.enters < in) v.enters = in;
        if (first || out < v.leaves) v.leaves = out;
        first = false;
    }
    if (v.leaves.n <= 0 || v.leaves < v.enters) return;
    for (const Visit& old : visits) {
        if (old.object == object) return;
    }
    visits.push_back(v);
}

}  // namespace

std::uint32_t BlockWorld::at(Cell c) const {
    for (const std::int64_t x : c) {
        if (x < 0 || x >= side) return kNone;
    }
    return object[static_cast<std::size_t>((c[2] * side + c[1]) * side + c[0])];
}

BlockWorld block_world(std::int64_t side, double filled, Vec3d corner, std::uint64_t seed) {
    BlockWorld world;
    world.side = side;
    Random random(seed);
    SceneMaker make;
    for (std::int64_t i = 0; i < side * side * side; ++i) {
        if (random.unit() >= filled) {
            world.object.push_back(BlockWorld::kNone);
            continue;
        }
        const Vec3d at =
            corner + Vec3d{static_cast<double>(i % side), static_cast<double>(i / side % side),
                           static_cast<double>(i / (side * side))};
        world.object.push_back(make.box(at, at + Vec3d{1, 1, 1}).value);
    }
    world.scene = make.scene;
    return world;
}

std::vector<Visit> walk_lattice(const BlockWorld& world, const LatticeRay& ray, int& steps) {
    std::vector<Visit> visits;
    // The cell that the ray is in just after its start; on a plane that it runs in, the upper one.
    Cell cell;
    std::array<bool, 3> in_plane{};
    for (std::size_t i = 0; i < 3; ++i) {
        cell[i] = floor_quarters(ray.origin[i]);
        const bool on_plane = ray.origin[i] % kQuarters == 0;
        if (on_plane && ray.direction[i] < 0) --cell[i];
        in_plane[i] = on_plane && ray.direction[i] == 0;
    }
    // A cell, and where the ray runs in planes of it those on their other sides.
    const auto look = [&](Cell c) {
        ++steps;
        for (unsigned sides = 0; sides < 8; ++sides) {
            Cell beside = c;
            bool real = true;
            for (std::size_t i = 0; i < 3; ++i) {
                if ((sides >> i & 1U) == 0) continue;
                real = real && in_plane[i];
                --beside[i];
            }
            if (real) visit(world, ray, beside, visits);
        }
    };
    look(cell);
    const auto outside = [&] {
        for (std::size_t i = 0; i < 3; ++i) {
            if (ray.direction[i] > 0 && cell[i] >= world.side) return true;
            if (ray.direction[i] < 0 && cell[i] < 0) return true;
            // The one below it, too, where the ray runs in a plane.
            const std::int64_t least = in_plane[i] ? -1 : 0;
            if (ray.direction[i] == 0 && (cell[i] < 0 || cell[i] > world.side + least + 1)) {
                return true;
            }
        }
        return false;
    };
    while (!outside()) {
        Ratio next[3];
        std::size_t nearest = 3;
        for (std::size_t i = 0; i < 3; ++i) {
            if (ray.direction[i] == 0) continue;
            next[i] = crossing(ray, i, cell[i] + (ray.direction[i] > 0 ? 1 : 0));
            if (nearest == 3 || next[i] < next[nearest]) nearest = i;
        }
        // All that are reached at once: cells that meet there in an edge or a corner are touched.
        unsigned crossed = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            if (ray.direction[i] != 0 && next[i] == next[nearest]) crossed |= 1U << i;
        }
        const Cell from = cell;
        for (unsigned some = 1; some < 8; ++some) {
            if ((some & ~crossed) != 0) continue;
            Cell to = from;
            for (std::size_t i = 0; i < 3; ++i) {
                if ((some >> i & 1U) != 0) to[i] += ray.direction[i] > 0 ? 1 : -1;
            }
            look(to);
            if (some == crossed) cell = to;
        }
    }
    std::stable_sort(visits.begin(), visits.end(),
                     [](const Visit& a, const Visit& b) { return a.enters < b.enters; });
    return visits;
}

}  // namespace cobble::test
