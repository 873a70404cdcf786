// SPDX-License-Identifier: MIT
// The walk through a tree: nearest child first, on a stack of its own. Private to this folder.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/accel/tree.hpp"
#include "renderer/query/query.hpp"

namespace cobble::renderer {

/// Where each of a node's boxes begins to span the ray, or infinity if it does not, or only
/// outside (t_min, t_best). The arithmetic of slab_span(), so that it is monotone with it.
template <bool kParallel, typename T>
inline void node_spans(const Node<T>& node, const RaySlabs<T>& ray, T t_min, T t_best,
                       Lanes<T>& begins) {
    const Lanes<T> zero{};
    const Lanes<T> infinity = zero + std::numeric_limits<T>::infinity();
    Lanes<T> near = zero + t_min;
    Lanes<T> far = zero + t_best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const T o = ray.origin[axis];
        if constexpr (kParallel) {
            if (ray.parallel[axis]) {
                near = o < node.bounds[0][axis] ? infinity : near;
                near = o > node.bounds[1][axis] ? infinity : near;
                continue;
            }
        }
        const std::size_t first = ray.negative[axis] ? 1 : 0;
        const Lanes<T> a = (node.bounds[first][axis] - o) * ray.inverse[axis];
        const Lanes<T> b = (node.bounds[1 - first][axis] - o) * ray.inverse_far[axis];
        near = a > near ? a : near;
        far = b < far ? b : far;
    }
    begins = near <= far ? near : infinity;
}

template <typename T>
struct Waiting {
    T near;
    std::uint32_t first;
    std::uint8_t count;  ///< 0: an inner node
    PrimitiveKind kind;
};

/// Calls leaf(kind, first, count) for every leaf whose box may hold a better hit, nearest first.
/// Stops early once `stop()` holds.
template <bool kParallel, typename T, typename Leaf, typename Stop>
void walk(const Tree<T>& tree, const RaySlabs<T>& ray, Search<T>& search, Leaf leaf, Stop stop) {
    constexpr std::size_t kWidth = Node<T>::kWidth;
    std::array<Waiting<T>, kTraversalStack> stack;
    std::size_t waiting = 0;
    Waiting<T> at{search.t_min, 0, 0, PrimitiveKind::kTriangle};
    for (;;) {
        if (at.count == 0) {
            const Node<T>& node = tree.nodes[at.first];
            search.box_tests += kWidth;
            Lanes<T> near;
            node_spans<kParallel>(node, ray, search.t_min, search.best.t, near);
            // Pushed with the farthest first, so that the nearest is taken next.
            const std::size_t base = waiting;
            for (std::size_t k = 0; k < kWidth; ++k) {
                if (!(near[k] <= std::numeric_limits<T>::max())) continue;
                std::size_t place = waiting++;
                while (place > base && stack[place - 1].near < near[k]) {
                    stack[place] = stack[place - 1];
                    --place;
                }
                stack[place] = {near[k], node.first[k], node.count[k], node.kind[k]};
            }
        } else {
            leaf(at.kind, at.first, at.count);
            if (stop()) return;
        }
        // Strictly beyond the best: an equal t may still win by its object.
        do {
            if (waiting == 0) return;
            at = stack[--waiting];
        } while (at.near > search.best.t);
    }
}

template <typename T, typename Leaf, typename Stop>
void traverse(const Tree<T>& tree, const RaySlabs<T>& ray, Search<T>& search, Leaf leaf,
              Stop stop) {
    if (tree.nodes.empty()) return;
    if (ray.any_parallel) {
        walk<true>(tree, ray, search, leaf, stop);
    } else {
        walk<false>(tree, ray, search, leaf, stop);
    }
}

}  // namespace cobble::renderer
