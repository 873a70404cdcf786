// SPDX-License-Identifier: MIT
// The walk of one ray through a tree, two nodes at a time.
//
// A step waits for what it reads, and for what the step before has answered, far longer than it
// computes; and a processor that guesses which child is nearest guesses wrong too often. So the
// children that a ray meets go on the stack without a branch, in an order that the tree was built
// with, and two nodes come off it at once.
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

/// Sets of slots whose numbers are turned by exclusive or.
struct TurnedSets {
    std::uint8_t bits[8][256];
};
constexpr TurnedSets make_turned_sets() {
    TurnedSets turned{};
    for (std::uint32_t by = 0; by < 8; ++by) {
        for (std::uint32_t bits = 0; bits < 256; ++bits) {
            std::uint32_t set = 0;
            for (std::uint32_t slot = 0; slot < 8; ++slot) set |= (bits >> slot & 1) << (slot ^ by);
            turned.bits[by][bits] = static_cast<std::uint8_t>(set);
        }
    }
    return turned;
}
inline constexpr TurnedSets kTurnedSets = make_turned_sets();

/// Lanes are moved together by one instruction, not by a table (Highway 1.0.3 has one of a kilobyte
/// for AVX2, and copies it onto the stack in each call).
#if HWY_TARGET <= HWY_AVX3 && HWY_TARGET != HWY_SCALAR
inline constexpr bool kCompresses = true;
#else
inline constexpr bool kCompresses = false;
#endif

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

/// Room for nodes that wait, the last to be taken first: of one level of the tree never more than
/// those of two nodes, but for one pair that has been taken. How many there are the walk keeps in a
/// register.
template <bool kAny, typename T>
class NodeStack {
    static constexpr std::size_t kWidth = WideNode<T>::kWidth;
    static constexpr std::size_t kMost = kMaxTreeDepth * 2 * (kWidth - 1) + 3 * kWidth;

  public:
    /// The root waits. `signs`: as in RayLanes.
    HWY_INLINE NodeStack(std::uint32_t signs, T t_min) : turn_(~signs & 7) {
        child_[0] = ChildRef::inner(0);
        if constexpr (!kAny) begins_[0] = t_min;
    }
    [[nodiscard]] HWY_INLINE const WideNode<T>& node(const WideNode<T>* nodes,
                                                     std::size_t i) const {
        return child_[i].node_in(nodes);
    }

    /// Puts the children in `bits` on top of `count`, and gives how many it are then. If the
    /// closest hit is asked for, the one that lies first by its slot comes last.
    [[nodiscard]] HWY_INLINE std::size_t push(std::size_t count, const WideNode<T>& node,
                                              std::uint32_t bits, const NodeSpans<T>& spans) {
        if constexpr (kAny) {
            return static_cast<std::size_t>(store_children(node, bits, child_ + count) - child_);
        } else {
            return push_in_order(count, node, bits, spans);
        }
    }

    /// Leaves those that begin at or before `best`: at an equal t an object may still win.
    [[nodiscard]] HWY_INLINE std::size_t cull(std::size_t count, T best) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const ChildRef child = child_[i];
            const T begin = begins_[i];
            child_[kept] = child;
            begins_[kept] = begin;
            kept += begin <= best ? 1 : 0;
        }
        return kept;
    }

  private:
    HWY_INLINE std::size_t push_in_order(std::size_t count, const WideNode<T>& node,
                                         std::uint32_t bits, const NodeSpans<T>& spans) {
        using D = hn::CappedTag<std::uint32_t, kWidth>;
        using DT = hn::CappedTag<T, kWidth>;
        if constexpr (sizeof(T) == sizeof(std::uint32_t) && hn::MaxLanes(D()) == kWidth) {
            const D d;
            const DT dt;
            const auto child = hn::Load(d, reinterpret_cast<const std::uint32_t*>(node.child));
            const auto begin = hn::Load(dt, spans.begins);
            const auto turn = hn::Set(d, turn_);
            auto* const to = reinterpret_cast<std::uint32_t*>(child_ + count);
            if constexpr (kCompresses) {
                // Turned first, beside what finds out which are met.
                const auto slots = hn::Xor(hn::Iota(d, 0), turn);
                const auto end =
                    hn::TableLookupLanes(hn::Load(dt, spans.ends), hn::IndicesFromVec(dt, slots));
                const auto turned_begin =
                    hn::TableLookupLanes(begin, hn::IndicesFromVec(dt, slots));
                const auto turned_child = hn::TableLookupLanes(child, hn::IndicesFromVec(d, slots));
                const auto inner = hn::Eq(hn::ShiftRight<29>(turned_child), hn::Zero(d));
                const auto met = hn::And(hn::Le(turned_begin, end), hn::RebindMask(dt, inner));
                hn::StoreU(hn::Compress(turned_child, hn::RebindMask(d, met)), d, to);
                hn::StoreU(hn::Compress(turned_begin, met), dt, begins_ + count);
            } else {
                const hn::Rebind<std::uint8_t, D> du8;
                const std::uint8_t* const list = kSlotLists.slots[kTurnedSets.bits[turn_][bits]];
                const auto slots = hn::Xor(hn::PromoteTo(d, hn::Load(du8, list)), turn);
                hn::StoreU(hn::TableLookupLanes(child, hn::IndicesFromVec(d, slots)), d, to);
                hn::StoreU(hn::TableLookupLanes(begin, hn::IndicesFromVec(dt, slots)), dt,
                           begins_ + count);
            }
            return count + hwy::PopCount(bits);
        } else {
            for (std::uint32_t left = kTurnedSets.bits[turn_][bits]; left != 0; left &= left - 1) {
                const std::size_t slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(left) ^ turn_;
                child_[count] = node.child[slot];
                begins_[count++] = spans.begins[slot];
            }
            return count;
        }
    }

    std::uint32_t turn_;
    ChildRef child_[kMost];
    T begins_[kAny ? 1 : kMost];
};

/// Walks one tree. `leaf(child)` is asked for each leaf that may hold a better hit; for any hit it
/// says whether the walk is over.
template <bool kAny, bool kParallel, typename T, typename Boxes, typename Leaf>
HWY_INLINE void walk_pairs(const WideTree<T>& tree, Boxes boxes, const RayLanes<T>& ray,
                           FormsOnDemand<T>& forms, Search<T>& search, Leaf leaf) {
    static_assert(kAny || !Boxes::kSome);
    if (tree.nodes.empty()) return;
    constexpr std::size_t kWidth = WideNode<T>::kWidth;
    const WideNode<T>* const nodes = tree.nodes.data();
    NodeStack<kAny, T> stack(ray.signs, search.t_min);
    std::size_t waiting = 1;
    ChildRef leaves[3 * kWidth];
    std::uint64_t steps = 0;
    while (waiting != 0) {
        const bool two = waiting > 1;
        const WideNode<T>& first = stack.node(nodes, waiting - 1);
        const WideNode<T>& second = stack.node(nodes, waiting - (two ? 2 : 1));
        waiting -= two ? 2 : 1;
        steps += two ? 2 : 1;
        NodeSpans<T> of_first;
        NodeSpans<T> of_second;
        const auto meet = [&](const WideNode<T>& node, NodeSpans<T>& spans) HWY_ATTR {
            const std::uint32_t bits = node_hits<kParallel>(node, ray.slabs, ray.parallel,
                                                            search.t_min, search.best.t, spans);
            return boxes.template test<kAny, T>(node, bits, spans, forms, search);
        };
        const std::uint32_t met_first = meet(first, of_first);
        const std::uint32_t met_second = two ? meet(second, of_second) : 0;
        if (Boxes::kSome && search.best.object.valid()) break;
        const std::uint32_t inner_first = met_first & inner_slots(first);
        const std::uint32_t inner_second = met_second & inner_slots(second);
        if (kAny || two) waiting = stack.push(waiting, second, inner_second, of_second);
        waiting = stack.push(waiting, first, inner_first, of_first);
        const std::uint32_t leaf_first = met_first ^ inner_first;
        const std::uint32_t leaf_second = met_second ^ inner_second;
        // Where boxes are slots, other leaves are few.
        if (Boxes::kSome && HWY_LIKELY((leaf_first | leaf_second) == 0)) continue;
        ChildRef* last = store_children(second, leaf_second, leaves);
        last = store_children(first, leaf_first, last);
        const T before = search.best.t;
        while (last != leaves) {
            if (leaf(*--last)) {
                search.box_tests += steps * kWidth;
                return;
            }
        }
        if (!kAny && search.best.t < before) waiting = stack.cull(waiting, search.best.t);
    }
    search.box_tests += steps * kWidth;
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
