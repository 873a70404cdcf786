// SPDX-License-Identifier: MIT
// The first half of building a wide tree: two children a node, by the binned surface-area heuristic
// over object splits (Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/accel/build_control.hpp"
#include "renderer/accel/builder.hpp"

namespace cobble::renderer {

/// What some items span, and where they are.
template <typename T>
struct BinaryNode {
    T lo[3];
    T hi[3];
    std::uint32_t at;  ///< the first item of a leaf, else the left child: the right one follows it
    std::uint32_t count;  ///< of a leaf's items; 0: there are children
    [[nodiscard]] bool leaf() const { return count > 0; }
    [[nodiscard]] BoxBounds<T> bounds() const {
        return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
    }
};

/// Nodes from the root at 0, children behind their parents and pairs of them at odd places. Those
/// that hang together above the subtrees come first; each subtree was built on its own and has its
/// nodes, but for its root, in one of the ranges. What lies between them is nothing.
template <typename T>
struct BinaryTree {
    struct Range {
        std::uint32_t begin, end;
    };
    std::unique_ptr<BinaryNode<T>[]> nodes;
    std::uint32_t all = 0;  ///< places of nodes
    std::uint32_t top = 0;  ///< nodes in no subtree, and roots of subtrees
    std::uint32_t leaves = 0;
    std::vector<Range> subtrees;
};

/// Reorders `items` (not none, and fewer than 2^30) so that each node's are neighbours. A leaf
/// holds what one slot of a wide node can lead to: up to a block of triangles or spheres, or one
/// thing of another kind. The same tree on every machine and however many work at it. O(n log n),
/// also for a million items in one place. Not to be used if it was cancelled.
template <typename T>
BinaryTree<T> build_binary_tree(std::vector<BuildItem<T>>& items, const BuildControl& control);

}  // namespace cobble::renderer
