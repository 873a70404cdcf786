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

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "renderer/accel/wide_tree.hpp"
#include "renderer/geometry/slab.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Which of a node's six rows of bounds a ray comes to first, and to last, on each axis: where in
/// the node they begin, in bytes.
struct SlabRows {
    std::uint32_t near[3], far[3];
};

/// `signs`: a bit for each axis along which the ray runs backward.
template <typename T>
constexpr SlabRows slab_rows_of(std::uint32_t signs) {
    constexpr auto kRow = static_cast<std::uint32_t>(WideNode<T>::kWidth * sizeof(T));
    SlabRows rows{};
    for (std::uint32_t a = 0; a < 3; ++a) {
        const bool negative = (signs >> a & 1) != 0;
        rows.near[a] = (negative ? a + 3 : a) * kRow;
        rows.far[a] = (negative ? a : a + 3) * kRow;
    }
    return rows;
}
template <typename T>
inline constexpr SlabRows kSlabRows[8] = {
    slab_rows_of<T>(0), slab_rows_of<T>(1), slab_rows_of<T>(2), slab_rows_of<T>(3),
    slab_rows_of<T>(4), slab_rows_of<T>(5), slab_rows_of<T>(6), slab_rows_of<T>(7)};

/// A ray's slabs with a copy in each lane.
template <typename T>
struct SlabLanes {
    using D = hn::CappedTag<T, WideNode<T>::kWidth>;
    using V = hn::Vec<D>;

    V origin[3], inverse[3], inverse_far[3];
    const SlabRows* rows;
};

template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> mask) {
    // Where it is the same, as one number: g++ would take it apart and put it together.
    if constexpr (std::endian::native == std::endian::little && hn::MaxLanes(D()) > 8) {
        std::uint8_t both[8];  // two are written: set to 0 before, they would be read as four
        hn::StoreMaskBits(d, mask, both);
        std::uint16_t bits = 0;
        std::memcpy(&bits, both, sizeof(bits));
        return bits;
    }
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return bytes[0] | std::uint32_t{bytes[1]} << 8;
}

/// The opposite: a lane for each of the lowest bits.
template <class D>
HWY_INLINE hn::Mask<D> mask_of(D d, std::uint32_t bits) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                   static_cast<std::uint8_t>(bits >> 8)};
    return hn::LoadMaskBits(d, bytes);
}

/// What a ray spans of a node's boxes: those are met that it leaves not before it enters.
template <typename T>
struct NodeSpans {
    alignas(64) T begins[WideNode<T>::kWidth];
    alignas(64) T ends[WideNode<T>::kWidth];
};

/// A bit for each slot whose box the ray meets in [t_min, t_best], and what it spans of it. The
/// arithmetic of slab_span(), so that it is monotone with it. `parallel`: a flag for each axis that
/// the ray runs beside; only for kParallel.
template <bool kParallel, typename T>
HWY_INLINE std::uint32_t node_hits(const WideNode<T>& node, const SlabLanes<T>& ray,
                                   const bool* parallel, T t_min, T t_best, NodeSpans<T>& spans) {
    using D = typename SlabLanes<T>::D;
    const D d;
    constexpr std::size_t kLanes = hn::MaxLanes(D());
    const auto row = [&](std::uint32_t at, std::size_t part) HWY_ATTR {
        const char* const bytes = reinterpret_cast<const char*>(node.bounds);
        return hn::Load(d, reinterpret_cast<const T*>(bytes + at) + part);
    };
    std::uint32_t bits = 0;
    for (std::size_t part = 0; part < WideNode<T>::kWidth; part += kLanes) {
        auto near = hn::Set(d, t_min);
        auto far = hn::Set(d, t_best);
        auto inside = hn::Eq(near, near);
        for (std::size_t a = 0; a < 3; ++a) {
            if constexpr (kParallel) {
                if (parallel[a]) {
                    inside = hn::And(
                        inside,
                        hn::And(hn::Le(hn::Load(d, node.bounds[a] + part), ray.origin[a]),
                                hn::Ge(hn::Load(d, node.bounds[a + 3] + part), ray.origin[a])));
                    continue;
                }
            }
            near = hn::Max(near, hn::Mul(hn::Sub(row(ray.rows->near[a], part), ray.origin[a]),
                                         ray.inverse[a]));
            far = hn::Min(far, hn::Mul(hn::Sub(row(ray.rows->far[a], part), ray.origin[a]),
                                       ray.inverse_far[a]));
        }
        if constexpr (kParallel) {
            far = hn::IfThenElse(inside, far, hn::Set(d, std::numeric_limits<T>::lowest()));
        }
        hn::Store(near, d, spans.begins + part);
        hn::Store(far, d, spans.ends + part);
        bits |= bits_of(d, hn::Le(near, far)) << part;
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
