// SPDX-License-Identifier: MIT
// The walk of one ray to any hit, two nodes at a time.
//
// A step waits for what it reads, and for what the step before has answered, far longer than it
// computes; and a processor that guesses how many children are met guesses wrong too often. So the
// children that a ray meets go on the stack without a branch, and two nodes come off it at once.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_PAIRS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_PAIRS_INL
#undef COBBLE_PAIRS_INL
#else
#define COBBLE_PAIRS_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "renderer/accel/tree.hpp"
#include "renderer/accel/wide_tree.hpp"
#include "renderer/query/query.hpp"
#include "renderer/wide/lanes-inl.hpp"
#include "renderer/wide/ray_rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

/// For each set of slots a byte for each slot in it, those of the lowest numbers first.
struct SlotLists {
    std::uint8_t slots[256][8];
};
constexpr SlotLists make_slot_lists() {
    SlotLists lists{};
    for (std::uint32_t bits = 0; bits < 256; ++bits) {
        std::uint32_t n = 0;
        for (std::uint8_t slot = 0; slot < 8; ++slot) {
            if ((bits >> slot & 1) != 0) lists.slots[bits][n++] = slot;
        }
    }
    return lists;
}
inline constexpr SlotLists kSlotLists = make_slot_lists();

/// The slots of a node that lead to other nodes.
template <typename T>
HWY_INLINE std::uint32_t inner_slots(const WideNode<T>& node) {
    using D = hn::CappedTag<std::uint32_t, WideNode<T>::kWidth>;
    const D d;
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < WideNode<T>::kWidth; part += hn::MaxLanes(D())) {
        const auto child = hn::Load(d, reinterpret_cast<const std::uint32_t*>(node.child) + part);
        bits |= bits_of(d, hn::Eq(hn::ShiftRight<29>(child), hn::Zero(d))) << part;
    }
    return bits;
}

/// Stores the children in `bits` one behind the other, and something behind them, eight in all.
/// Gives the place behind the children.
template <typename T>
HWY_INLINE ChildRef* store_children(const WideNode<T>& node, std::uint32_t bits, ChildRef* to) {
    using D = hn::CappedTag<std::uint32_t, WideNode<T>::kWidth>;
    const D d;
    if constexpr (hn::MaxLanes(D()) == WideNode<T>::kWidth) {
        const hn::Rebind<std::uint8_t, D> du8;
        const auto slots = hn::PromoteTo(d, hn::Load(du8, kSlotLists.slots[bits]));
        const auto children = hn::Load(d, reinterpret_cast<const std::uint32_t*>(node.child));
        hn::StoreU(hn::TableLookupLanes(children, hn::IndicesFromVec(d, slots)), d,
                   reinterpret_cast<std::uint32_t*>(to));
        return to + hwy::PopCount(bits);
    } else {
        for (; bits != 0; bits &= bits - 1) {
            *to++ = node.child[hwy::Num0BitsBelowLS1Bit_Nonzero32(bits)];
        }
        return to;
    }
}

/// Walks one tree to any hit: there is no order to keep. `leaf(child)` is asked for each leaf that
/// may hold one, and says whether it does.
template <bool kParallel, typename T, typename Boxes, typename Leaf>
HWY_INLINE void walk_pairs(const WideTree<T>& tree, Boxes boxes, const RayLanes<T>& ray,
                           FormsOnDemand<T>& forms, Search<T>& search, Leaf leaf) {
    if (tree.nodes.empty()) return;
    constexpr std::size_t kWidth = WideNode<T>::kWidth;
    const WideNode<T>* const nodes = tree.nodes.data();
    // Of one level of the tree never more than those of two nodes wait, but for one pair that has
    // been taken; and store_children() writes eight, of which the met ones count.
    ChildRef stack[kMaxTreeDepth * 2 * (kWidth - 1) + 3 * kWidth];
    ChildRef leaves[3 * kWidth];
    ChildRef* top = stack;
    *top++ = ChildRef::inner(0);
    std::uint64_t steps = 0;
    const auto meet = [&](const WideNode<T>& node) HWY_ATTR {
        NodeSpans<T> spans;
        const std::uint32_t bits =
            node_hits<kParallel>(node, ray.slabs, ray.parallel, search.t_min, search.best.t, spans);
        return boxes.template test<true, T>(node, bits, spans, forms, search);
    };
    do {
        const bool two = top - stack > 1;
        const WideNode<T>& first = top[-1].node_in(nodes);
        const WideNode<T>& second = top[two ? -2 : -1].node_in(nodes);
        top -= two ? 2 : 1;
        steps += two ? 2 : 1;
        const std::uint32_t met_first = meet(first);
        const std::uint32_t met_second = two ? meet(second) : 0;
        if (Boxes::kSome && search.best.object.valid()) break;
        const std::uint32_t inner_first = met_first & inner_slots(first);
        const std::uint32_t inner_second = met_second & inner_slots(second);
        top = store_children(second, inner_second, top);
        top = store_children(first, inner_first, top);
        const std::uint32_t leaf_first = met_first ^ inner_first;
        const std::uint32_t leaf_second = met_second ^ inner_second;
        // Where boxes are slots, other leaves are few.
        if (Boxes::kSome && HWY_LIKELY((leaf_first | leaf_second) == 0)) continue;
        ChildRef* last = store_children(second, leaf_second, leaves);
        last = store_children(first, leaf_first, last);
        while (last != leaves) {
            if (leaf(*--last)) {
                search.box_tests += steps * kWidth;
                return;
            }
        }
    } while (top != stack);
    search.box_tests += steps * kWidth;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
