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

template <typename T>
struct WaitingChild {
    T near;
    ChildRef child;
};

/// Walks one tree, the nearest child first; `leaf(child)` is asked for each leaf that may hold a
/// better hit.
template <bool kParallel, typename T, typename Boxes, typename Leaf>
HWY_INLINE void walk_nearest_first(const WideTree<T>& tree, Boxes boxes, const RayLanes<T>& ray,
                                   FormsOnDemand<T>& forms, Search<T>& search, Leaf leaf) {
    if (tree.nodes.empty()) return;
    constexpr std::size_t kWidth = WideNode<T>::kWidth;
    const WideNode<T>* const nodes = tree.nodes.data();
    WaitingChild<T> stack[kMaxTreeDepth * (kWidth - 1) + kWidth];
    WaitingChild<T>* top = stack;
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
                const T* const begins = spans.begins;
                const auto first = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                at = node.child[first];
                if (bits == 0) continue;
                const auto second = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                const bool swapped = begins[second] < begins[first];
                const WaitingChild<T> pair[2] = {{begins[first], at},
                                                 {begins[second], node.child[second]}};
                at = pair[swapped ? 1 : 0].child;
                WaitingChild<T>* const base = top;
                *top++ = pair[swapped ? 0 : 1];
                if (bits == 0) continue;
                *top++ = pair[swapped ? 1 : 0];
                do {
                    const auto slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                    bits &= bits - 1;
                    const WaitingChild<T> next{begins[slot], node.child[slot]};
                    // The farthest first, so that the nearest is taken next.
                    WaitingChild<T>* place = top++;
                    while (place > base && place[-1].near < next.near) {
                        *place = place[-1];
                        --place;
                    }
                    *place = next;
                } while (bits != 0);
                at = (--top)->child;
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
        } while (top->near > search.best.t);
        at = top->child;
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
