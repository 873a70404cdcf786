// SPDX-License-Identifier: MIT
// The walk of one ray through a tree, on a stack of its own.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_WALK_INL
#undef COBBLE_WALK_INL
#else
#define COBBLE_WALK_INL
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/accel/tree.hpp"
#include "renderer/accel/wide_tree.hpp"
#include "renderer/query/query.hpp"
#include "renderer/wide/box_slots-inl.hpp"
#include "renderer/wide/lanes-inl.hpp"
#include "renderer/wide/pairs-inl.hpp"
#include "renderer/wide/ray_rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

/// A child that waits, and where its box begins: in float one number, in order of where that is
/// (which is nowhere below zero, and -0 may come before 0).
template <typename T>
struct WaitingChild {
    T begin;
    ChildRef child;

    WaitingChild() = default;
    WaitingChild(T of_box, ChildRef to) : begin(of_box), child(to) {}
    [[nodiscard]] T near() const { return begin; }
    [[nodiscard]] ChildRef to() const { return child; }
    [[nodiscard]] bool operator<(const WaitingChild& other) const { return begin < other.begin; }
};
template <>
struct WaitingChild<float> {
    std::int64_t bits;

    WaitingChild() = default;
    WaitingChild(float of_box, ChildRef to)
        : bits(static_cast<std::int64_t>(std::uint64_t{std::bit_cast<std::uint32_t>(of_box)} << 32 |
                                         to.bits())) {}
    [[nodiscard]] float near() const {
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits >> 32));
    }
    [[nodiscard]] ChildRef to() const {
        return ChildRef::of_bits(static_cast<std::uint32_t>(bits));
    }
    [[nodiscard]] bool operator<(const WaitingChild& other) const { return bits < other.bits; }
};

/// The child in the lowest of the slots in `bits`, which it is taken out of.
template <typename T>
HWY_INLINE WaitingChild<T> take_child(const WideNode<T>& node, const NodeSpans<T>& spans,
                                      std::uint32_t& bits) {
    const auto slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
    bits &= bits - 1;
    return {spans.begins[slot], node.child[slot]};
}

/// Walks one tree, the nearest child first; `leaf(child)` is asked for each leaf that may hold a
/// better hit.
template <bool kParallel, typename T, typename Boxes, typename Leaf>
HWY_INLINE void walk_nearest_first(const WideTree<T>& tree, Boxes boxes, const RayLanes<T>& ray,
                                   FormsOnDemand<T>& forms, Search<T>& search, Leaf leaf) {
    if (tree.nodes.empty()) return;
    constexpr std::size_t kWidth = WideNode<T>::kWidth;
    const WideNode<T>* const nodes = tree.nodes.data();
    using Waiting = WaitingChild<T>;
    Waiting stack[kMaxTreeDepth * (kWidth - 1) + kWidth];
    Waiting* top = stack;
    ChildRef at = ChildRef::inner(0);
    std::uint64_t steps = 0;
    for (;;) {
        if (HWY_LIKELY(at.is_inner())) {
            const WideNode<T>& node = at.node_in(nodes);
            ++steps;
            NodeSpans<T> spans;
            std::uint32_t bits = node_hits<kParallel>(node, ray.slabs, ray.parallel, search.t_min,
                                                      search.best.t, spans);
            bits = boxes.template test<false, T>(node, bits, spans, forms, search);
            if (bits != 0) {
                const Waiting first = take_child(node, spans, bits);
                at = first.to();
                if (bits == 0) continue;
                const Waiting second = take_child(node, spans, bits);
                const bool swapped = second < first;
                Waiting nearest = swapped ? second : first;
                Waiting* const base = top;
                *top++ = swapped ? first : second;
                while (bits != 0) {
                    const Waiting next = take_child(node, spans, bits);
                    const bool nearer = next < nearest;
                    const Waiting other = nearer ? nearest : next;
                    nearest = nearer ? next : nearest;
                    // The farthest first, so that the nearest is taken next.
                    Waiting* place = top++;
                    while (place > base && place[-1] < other) {
                        *place = place[-1];
                        --place;
                    }
                    *place = other;
                }
                at = nearest.to();
                continue;
            }
        } else {
            leaf(at);
        }
        // Strictly beyond the best: an equal t may still win by its object.
        do {
            if (top == stack) {
                search.box_tests += steps * kWidth;
                boxes.template settle<T>(forms, search);
                return;
            }
            --top;
        } while (top->near() > search.best.t);
        at = top->to();
    }
}

/// The closest hit; or any, and then `leaf` says whether it has found one.
template <bool kAny, bool kParallel, typename T, typename Boxes, typename Leaf>
HWY_INLINE void walk_wide(const WideTree<T>& tree, Boxes boxes, const RayLanes<T>& ray,
                          FormsOnDemand<T>& forms, Search<T>& search, Leaf leaf) {
    if constexpr (kAny) {
        walk_pairs<kParallel>(tree, boxes, ray, forms, search, leaf);
    } else {
        walk_nearest_first<kParallel>(tree, boxes, ray, forms, search, leaf);
    }
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
