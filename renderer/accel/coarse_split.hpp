// SPDX-License-Identifier: MIT
// Several levels of a tree over many items at once: they are read twice for all of the levels, not
// twice for each, which matters for those that do not fit into a processor's own cache.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/accel/build_kernels.hpp"

namespace cobble::renderer {

/// From so many items on it pays; those of a node of fewer are sorted no further.
inline constexpr std::uint32_t kManyItems = 1U << 14;
inline constexpr std::uint32_t kCoarseItems = 1U << 12;

/// A node of the levels, or where they end.
template <typename T>
struct CoarseNode {
    ItemExtents<T> extents;
    std::uint32_t first, count;
    std::uint32_t depth;  ///< below the root's 0
    std::uint32_t left;   ///< child, the right one follows it; 0: the levels end here
};

/// Sorts items, of which `extents` are, into the cells of a grid, and splits sets of cells by the
/// surface-area heuristic as long as they are at least eight wide along some axis. The items go
/// `to` a place elsewhere, those of each last node together, in their order. No node is deeper
/// than `levels`. Just the root, and no item moved, if their middles are in one place. The same on
/// every machine.
template <typename T>
std::vector<CoarseNode<T>> split_coarsely(const BuildItem<T>* items, std::uint32_t count,
                                          const ItemExtents<T>& extents, std::uint32_t levels,
                                          BuildItem<T>* to);

}  // namespace cobble::renderer
