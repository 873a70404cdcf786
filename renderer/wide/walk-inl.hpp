// SPDX-License-Identifier: MIT
// The walk of one ray through a tree: nearest child first, on a stack of its own.
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

#include "renderer/accel/tree.hpp"
#include "renderer/accel/wide_tree.hpp"
#include "renderer/query/query.hpp"
#include "renderer/wide/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

template <typename T>
struct WaitingChild {
    T near;
    ChildRef child;
};

/// Walks one tree; `leaf(child)` is asked for each leaf that may hold a better hit. A slot that is
/// a box of the scene is tested at once: `boxes` says whose it is, or is null if there are none.
template <bool kAny, bool kParallel, typename T, typename Leaf>
HWY_INLINE void walk_wide(const WideTree<T>& tree, const ir::ObjectId* boxes,
                          const RayForms<T>& ray, Search<T>& search, Leaf leaf) {
    if (tree.nodes.empty()) return;
    constexpr std::size_t kWidth = WideNode<T>::kWidth;
    const SlabLanes<T> lanes(ray.slabs);
    const WideNode<T>* const nodes = tree.nodes.data();
    WaitingChild<T> stack[kMaxTreeDepth * (kWidth - 1) + kWidth];
    WaitingChild<T>* top = stack;
    ChildRef at = ChildRef::inner(0);
    std::uint64_t steps = 0;
    for (;;) {
        if (HWY_LIKELY(at.is_inner())) {
            const WideNode<T>& node = nodes[at.index()];
            ++steps;
            alignas(64) T begins[kWidth];
            std::uint32_t bits =
                node_hits<kParallel>(node, ray.slabs, lanes, search.t_min, search.best.t, begins);
            if (boxes != nullptr && bits != 0) {
                std::uint32_t own = bits & box_slots(node);
                bits &= ~own;
                while (own != 0) {
                    const auto slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(own);
                    own &= own - 1;
                    test_box(ray, slot_bounds(node, slot), boxes[node.child[slot].index()], search);
                    if (kAny && search.best.object.valid()) {
                        search.box_tests += steps * kWidth;
                        return;
                    }
                }
            }
            if (bits != 0) {
                const auto first = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                bits &= bits - 1;
                at = node.child[first];
                if (bits == 0) continue;
                if constexpr (kAny) {
                    // Any order will do: what is farther than the end has been left out already.
                    do {
                        const auto slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(bits);
                        bits &= bits - 1;
                        *top++ = {search.t_min, node.child[slot]};
                    } while (bits != 0);
                    continue;
                }
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
            if constexpr (kAny) {
                if (search.best.object.valid()) break;
            }
        }
        // Strictly beyond the best: an equal t may still win by its object.
        do {
            if (top == stack) {
                search.box_tests += steps * kWidth;
                return;
            }
            --top;
        } while (top->near > search.best.t);
        at = top->child;
    }
    search.box_tests += steps * kWidth;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
