// SPDX-License-Identifier: MIT
// Worlds of unit blocks, and which of them a ray meets, by whole numbers alone.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/hard/scenes.hpp"

namespace cobble::test {

using Cell = std::array<std::int64_t, 3>;

/// Blocks at some cells of a cube of cells, each a box of its own in one scene.
struct BlockWorld {
    std::int64_t side = 0;
    std::vector<std::uint32_t> object;  ///< by cell, x fastest; kNone where there is none
    ir::Scene scene;

    static constexpr std::uint32_t kNone = 0xffffffffU;
    [[nodiscard]] std::uint32_t at(Cell c) const;
};

/// Each cell of `side`^3 holds a block with the chance `filled`; the cube's least corner is at
/// `corner`, which is to be whole numbers.
BlockWorld block_world(std::int64_t side, double filled, Vec3d corner, std::uint64_t seed);

/// A ray in whole numbers: it starts at a quarter of `origin`, relative to the world's corner.
struct LatticeRay {
    Cell origin;     ///< in quarters of a cell
    Cell direction;  ///< not all 0
};

/// A number n / d, d > 0, of which products fit 64 bits.
struct Ratio {
    std::int64_t n = 0;
    std::int64_t d = 1;
    friend bool operator<(Ratio a, Ratio b) { return a.n * b.d < b.n * a.d; }
    friend bool operator==(Ratio a, Ratio b) { return a.n * b.d == b.n * a.d; }
    [[nodiscard]] double value() const { return static_cast<double>(n) / static_cast<double>(d); }
};

/// A block that the ray meets: its closed cube and the ray, from t = 0 on and beyond it, share at
/// least a point.
struct Visit {
    std::uint32_t object = 0;
    Ratio enters;  ///< below 0 where the ray starts inside
    Ratio leaves;  ///< above 0
};

/// In the order of where they are entered: walks from cell to cell, over all axes at once where the
/// ray goes through an edge or a corner. `steps` counts the cells that were looked at.
std::vector<Visit> walk_lattice(const BlockWorld& world, const LatticeRay& ray, int& steps);

}  // namespace cobble::test
