// SPDX-License-Identifier: MIT
// Builds a Tree: binned surface-area heuristic (Wald, On fast Construction of SAH-based Bounding
// Volume Hierarchies, 2007), two children at a time, then collapsed to four.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "renderer/accel/build_item.hpp"
#include "renderer/accel/tree.hpp"

namespace cobble::renderer {

/// Reorders `items` so that each leaf's are neighbours of one kind, and gives the tree. A leaf's
/// `first` counts items of its own kind, in the new order: the caller sorts each kind's array to
/// match. Serial, the same on every machine; O(n log n), also for a million items in one place. If
/// `cancelled` is given and becomes true, returns soon, with an empty tree.
template <typename T>
Tree<T> build_tree(std::vector<BuildItem<T>>& items, const std::atomic<bool>* cancelled = nullptr);

}  // namespace cobble::renderer
