// SPDX-License-Identifier: MIT
// A node's eight boxes at once.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_LANES_INL
#undef COBBLE_LANES_INL
#else
#define COBBLE_LANES_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "renderer/accel/wide_tree.hpp"
#include "renderer/geometry/slab.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A ray's slabs with a copy in each lane.
template <typename T>
struct SlabLanes {
    using D = hn::CappedTag<T, WideNode<T>::kWidth>;
    using V = hn::Vec<D>;

    V origin[3], inverse[3], inverse_far[3];
    std::size_t near[3], far[3];  ///< which of a node's six rows of bounds come first and last

    explicit SlabLanes(const RaySlabs<T>& ray) {
        const D d;
        for (std::size_t a = 0; a < 3; ++a) {
            origin[a] = hn::Set(d, ray.origin[a]);
            inverse[a] = hn::Set(d, ray.inverse[a]);
            inverse_far[a] = hn::Set(d, ray.inverse_far[a]);
            near[a] = ray.negative[a] ? a + 3 : a;
            far[a] = ray.negative[a] ? a : a + 3;
        }
    }
};

template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0] | std::uint32_t{bytes[1]} << 8;
}

/// A bit for each slot whose box the ray meets in [t_min, t_best], and where it begins to. The
/// arithmetic of slab_span(), so that it is monotone with it.
template <bool kParallel, typename T>
HWY_INLINE std::uint32_t node_hits(const WideNode<T>& node, const RaySlabs<T>& ray,
                                   const SlabLanes<T>& lanes, T t_min, T t_best, T* begins) {
    using D = typename SlabLanes<T>::D;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < WideNode<T>::kWidth; part += kLanes) {
        auto near = hn::Set(d, t_min);
        auto far = hn::Set(d, t_best);
        auto inside = hn::Eq(near, near);
        for (std::size_t a = 0; a < 3; ++a) {
            if constexpr (kParallel) {
                if (ray.parallel[a]) {
                    inside = hn::And(
                        inside,
                        hn::And(hn::Le(hn::Load(d, node.bounds[a] + part), lanes.origin[a]),
                                hn::Ge(hn::Load(d, node.bounds[a + 3] + part), lanes.origin[a])));
                    continue;
                }
            }
            near = hn::Max(near, hn::Mul(hn::Sub(hn::Load(d, node.bounds[lanes.near[a]] + part),
                                                 lanes.origin[a]),
                                         lanes.inverse[a]));
            far = hn::Min(far, hn::Mul(hn::Sub(hn::Load(d, node.bounds[lanes.far[a]] + part),
                                               lanes.origin[a]),
                                       lanes.inverse_far[a]));
        }
        auto met = hn::Le(near, far);
        if constexpr (kParallel) met = hn::And(met, inside);
        hn::Store(near, d, begins + part);
        bits |= bits_of(d, met) << part;
    }
    return bits;
}

/// The slots that are boxes of the scene.
template <typename T>
HWY_INLINE std::uint32_t box_slots(const WideNode<T>& node) {
    using D = hn::CappedTag<std::uint32_t, WideNode<T>::kWidth>;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const auto box = hn::Set(d, ChildRef::leaf(PrimitiveKind::kBox, 0, 1).bits() >> 29);
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < WideNode<T>::kWidth; part += kLanes) {
        const auto child = hn::Load(d, reinterpret_cast<const std::uint32_t*>(node.child) + part);
        bits |= bits_of(d, hn::Eq(hn::ShiftRight<29>(child), box)) << part;
    }
    return bits;
}

template <typename T>
BoxBounds<T> slot_bounds(const WideNode<T>& node, std::size_t slot) {
    return {{node.bounds[0][slot], node.bounds[1][slot], node.bounds[2][slot]},
            {node.bounds[3][slot], node.bounds[4][slot], node.bounds[5][slot]}};
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
