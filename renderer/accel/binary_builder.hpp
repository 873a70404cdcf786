// SPDX-License-Identifier: MIT
// The first half of building a wide tree: two children a node, by the binned surface-area heuristic
// over object splits (Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007).
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/accel/build_control.hpp"
#include "renderer/accel/builder.hpp"

namespace cobble::renderer {

/// Items [first, first + count) and what they span.
template <typename T>
struct BinaryNode {
    BoxBounds<T> bounds;
    std::uint32_t left = 0;  ///< the right one follows it; 0: a leaf
    std::uint32_t first = 0, count = 0;
    [[nodiscard]] bool leaf() const { return left == 0; }
};

/// Nodes from the root at 0, children behind their parents, and where the subtrees begin that were
/// built on their own: their nodes lie together, from one to the next.
template <typename T>
struct BinaryTree {
    std::vector<BinaryNode<T>> nodes;
    std::vector<std::uint32_t> subtrees;
};

/// Reorders `items` (not none, and fewer than 2^31) so that each node's are neighbours. A leaf
/// holds what one slot of a wide node can lead to: up to a block of triangles or spheres, or one
/// thing of another kind. The same tree on every machine and however many work at it. O(n log n),
/// also for a million items in one place. Not to be used if it was cancelled.
template <typename T>
BinaryTree<T> build_binary_tree(std::vector<BuildItem<T>>& items, const BuildControl& control);

}  // namespace cobble::renderer
