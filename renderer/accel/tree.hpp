// SPDX-License-Identifier: MIT
// A bounding volume hierarchy with four children a node.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/geometry/primitives.hpp"

namespace cobble::renderer {

/// Four numbers, added and compared lane by lane: g++'s and clang's vector extension, which becomes
/// whatever the target has (SSE2 on x86-64, NEON, WebAssembly's 128 bits), the same bits on all.
template <typename T>
struct LanesOf;
template <>
struct LanesOf<float> {
    using type [[gnu::vector_size(16)]] = float;
};
template <>
struct LanesOf<double> {
    using type [[gnu::vector_size(32)]] = double;
};
template <typename T>
using Lanes = typename LanesOf<T>::type;

/// Four boxes, each an inner node or a leaf; lanes beside each other so that one step tests all.
/// 128 bytes in float: two cache lines. An empty slot's box is inside out and never met.
template <typename T>
struct Node {
    static constexpr std::size_t kWidth = 4;

    Lanes<T> bounds[2][3];        ///< [0]: least, [1]: greatest; axis; a lane for each child
    std::uint32_t first[kWidth];  ///< inner: index of a node; leaf: of its first primitive
    std::uint8_t count[kWidth];   ///< of the leaf's primitives; 0: inner
    PrimitiveKind kind[kWidth];   ///< of the leaf's primitives: all of one kind
};

/// Nodes from the root at 0; none if there is nothing in it. Children follow their parents.
template <typename T>
struct Tree {
    std::vector<Node<T>> nodes;
    BoxBounds<T> bounds;
};

/// Levels that any tree may have, by construction (see the builder), and so the bound for the stack
/// of a traversal: at most Node::kWidth - 1 entries wait at each level.
inline constexpr std::size_t kMaxTreeDepth = 80;
/// From this level on builders halve items, at most 2^32 of them, whatever their heuristic says,
/// and part what is left by its kind.
inline constexpr std::uint32_t kHalvingDepth = 40;
static_assert(kHalvingDepth + 32 + kPrimitiveKinds < kMaxTreeDepth);
inline constexpr std::size_t kTraversalStack = kMaxTreeDepth * 3 + 4;

}  // namespace cobble::renderer
