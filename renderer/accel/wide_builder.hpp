// SPDX-License-Identifier: MIT
// Builds a WideTree: a binary tree, collapsed to eight children a node.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/accel/build_control.hpp"
#include "renderer/accel/builder.hpp"
#include "renderer/accel/wide_tree.hpp"

namespace cobble::renderer {

/// Items [first, first + count) of the builder's order: one block.
struct LeafRange {
    std::uint32_t first, count;
};

/// The nodes, and what to fill the blocks with.
template <typename T>
struct WideBuild {
    LargeVector<WideNode<T>> nodes;
    std::vector<LeafRange> triangle_blocks;
    std::vector<LeafRange> sphere_blocks;
    BoxBounds<T> bounds;
};

/// Reorders `items` so that each block's are neighbours. Slots of boxes, instances and moving
/// things carry the item's own index. The same on every machine, however many work at it;
/// O(n log n), also for a million items in one place. Throws TooManyThings beyond kMostThings.
template <typename T>
WideBuild<T> build_wide_tree(std::vector<BuildItem<T>>& items, const BuildControl& control = {});

/// The tree itself: the nodes, with copies of the triangles and spheres in its blocks. An item's
/// index is that of its primitive in the array of its kind, a box's that of its object.
template <typename T>
WideTree<T> make_wide_tree(std::vector<BuildItem<T>>& items,
                           std::span<const TrianglePrimitive<T>> triangles,
                           std::span<const SpherePrimitive<T>> spheres,
                           const BuildControl& control = {});

}  // namespace cobble::renderer
