// SPDX-License-Identifier: MIT
// The fast core's tree: eight children a node, leaves laid out for SIMD.
//
// One layout serves every instruction set: a kernel with four lanes takes a node in two steps. What
// a leaf holds stands beside each other by coordinate, four triangles or eight spheres at a time; a
// box needs no leaf at all, since a node's slot is a box.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ir/scene/ids.hpp"
#include "renderer/accel/large_pages.hpp"
#include "renderer/geometry/primitives.hpp"

namespace cobble::renderer {

/// What a slot of a node leads to, in 32 bits: a kind, how many triangles, and where they are.
class ChildRef {
  public:
    static constexpr std::uint32_t kMostIndex = (1U << 27) - 1;
    /// A node's size in units of its alignment: a node is found by a shift alone.
    static constexpr std::uint32_t kNodeUnits = 7;

    constexpr ChildRef() = default;
    /// `node` is at most kMostNode.
    static constexpr ChildRef inner(std::uint32_t node) { return ChildRef(node * kNodeUnits); }
    static constexpr std::uint32_t kMostNode = ((1U << 29) - 1) / kNodeUnits;
    /// `index` is a block for triangles and spheres, the object for boxes, else the primitive.
    /// `count`: the triangles of the block; 1 for all others.
    static constexpr ChildRef leaf(PrimitiveKind kind, std::uint32_t index, std::uint32_t count) {
        return ChildRef((static_cast<std::uint32_t>(kind) + 1) << 29 | (count - 1) << 27 | index);
    }

    /// What bits() gave.
    static constexpr ChildRef of_bits(std::uint32_t bits) { return ChildRef(bits); }

    [[nodiscard]] constexpr bool is_inner() const { return bits_ >> 29 == 0; }
    [[nodiscard]] constexpr PrimitiveKind kind() const {
        return static_cast<PrimitiveKind>((bits_ >> 29) - 1);
    }
    [[nodiscard]] constexpr std::uint32_t count() const { return (bits_ >> 27 & 3) + 1; }
    [[nodiscard]] constexpr std::uint32_t index() const { return bits_ & kMostIndex; }
    [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }
    /// Of an inner one.
    template <typename Node>
    [[nodiscard]] const Node& node_in(const Node* nodes) const {
        static_assert(sizeof(Node) == kNodeUnits * alignof(Node));
        return *reinterpret_cast<const Node*>(reinterpret_cast<const char*>(nodes) +
                                              std::size_t{bits_} * alignof(Node));
    }

  private:
    explicit constexpr ChildRef(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_;  // no value of its own: stacks of hundreds are made for each ray
};
static_assert(kPrimitiveKinds < 7);

/// Whose box a slot is.
constexpr ir::ObjectId box_object(ChildRef box) { return ir::ObjectId{box.index()}; }

/// Eight boxes, a lane each. 224 bytes in float: three and a half cache lines. An empty slot's box
/// is inside out and never met.
template <typename T>
struct alignas(8 * sizeof(T)) WideNode {
    static constexpr std::size_t kWidth = 8;

    T bounds[6][kWidth];  ///< least x, y, z, greatest x, y, z
    ChildRef child[kWidth];
};

inline constexpr std::size_t kBlockLanes = 4;

/// Up to four triangles. The lanes behind the last repeat the first, so that a test of all four
/// finds no more than is there.
template <typename T>
struct alignas(4 * sizeof(T)) TriangleBlock {
    T vertices[3][3][kBlockLanes];  ///< corner, axis
    ir::ObjectId object[kBlockLanes];
    std::uint32_t face[kBlockLanes];
};

inline constexpr std::size_t kSphereLanes = 8;

/// Up to eight spheres. The lanes behind the last repeat the first, but for their object: none.
template <typename T>
struct alignas(32) SphereBlock {
    T center[3][kSphereLanes];
    T radius[kSphereLanes];
    ir::ObjectId object[kSphereLanes];
};

/// Nodes from the root at 0, each subtree's together; none if there is nothing in it.
template <typename T>
struct WideTree {
    LargeVector<WideNode<T>> nodes;
    LargeVector<TriangleBlock<T>> triangles;
    LargeVector<SphereBlock<T>> spheres;
    BoxBounds<T> bounds;
};

}  // namespace cobble::renderer
