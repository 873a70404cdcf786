// SPDX-License-Identifier: MIT
// Boxes of the scene, which are slots of a tree's nodes, against one ray.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_BOX_SLOTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_BOX_SLOTS_INL
#undef COBBLE_BOX_SLOTS_INL
#else
#define COBBLE_BOX_SLOTS_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/accel/wide_tree.hpp"
#include "renderer/query/query.hpp"
#include "renderer/wide/lanes-inl.hpp"
#include "renderer/wide/ray_rows-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

/// The far ends of spans are widened, by less than what this takes away.
template <typename T>
inline constexpr T kNarrowed = 1 - 16 * std::numeric_limits<T>::epsilon();

/// A tree without boxes of the scene.
struct NoBoxSlots {
    static constexpr bool kSome = false;

    template <bool kAny, typename T>
    HWY_INLINE std::uint32_t test(const WideNode<T>&, std::uint32_t bits, const NodeSpans<T>&,
                                  FormsOnDemand<T>&, Search<T>&) {
        return bits;
    }
    template <typename T>
    HWY_INLINE void settle(FormsOnDemand<T>&, Search<T>&) const {}
};

/// Slots of a node that are boxes of the scene: whose they are, and the nearest one met so far,
/// whose face is not computed yet.
template <typename T>
class BoxSlots {
  public:
    static constexpr bool kSome = true;

    /// Tests the slots among `bits` that are boxes, and gives the others. Where a ray surely meets
    /// a box ahead of it, what it spans is what test_box() computes, and only the face waits.
    template <bool kAny, typename>
    HWY_INLINE std::uint32_t test(const WideNode<T>& node, std::uint32_t bits,
                                  const NodeSpans<T>& spans, FormsOnDemand<T>& forms,
                                  Search<T>& search) {
        if (bits == 0) return 0;
        std::uint32_t own = bits & box_slots(node);
        bits &= ~own;
        while (own != 0) {
            const auto slot = hwy::Num0BitsBelowLS1Bit_Nonzero32(own);
            own &= own - 1;
            const ir::ObjectId object = box_object(node.child[slot]);
            const T t = spans.begins[slot];
            const bool left = object == search.exclude.object;
            if (left && !search.exclude.goes_inside) continue;
            if (HWY_UNLIKELY(left || !(t > search.t_min && t <= spans.ends[slot] * kNarrowed<T>))) {
                test_box(forms.get(), slot_bounds(node, slot), object, search);
            } else {
                ++search.primitive_tests;
                if (t < search.best.t || (t == search.best.t && search.best.object.valid() &&
                                          object < search.best.object)) {
                    search.best.t = t;
                    search.best.object = object;
                    node_ = &node;
                    slot_ = slot;
                }
            }
            if (kAny && search.best.object.valid()) return 0;
        }
        return bits;
    }

    /// Computes what waits of the nearest box, unless something nearer has come after it.
    template <typename>
    HWY_INLINE void settle(FormsOnDemand<T>& forms, Search<T>& search) const {
        if (node_ == nullptr) return;
        const ir::ObjectId object = box_object(node_->child[slot_]);
        if (!(object == search.best.object)) return;
        const auto hit = intersect_box(forms.get().slabs, slot_bounds(*node_, slot_));
        search.best = {hit->near, object, hit->near_face, 0, 0};
    }

  private:
    const WideNode<T>* node_ = nullptr;
    std::size_t slot_ = 0;
};

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
