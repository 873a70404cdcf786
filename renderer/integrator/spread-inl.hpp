// SPDX-License-Identifier: MIT
// Values of a few surfaces, spread over the hits that meet them.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_SPREAD_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_SPREAD_INL
#undef COBBLE_SPREAD_INL
#else
#define COBBLE_SPREAD_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "renderer/integrator/columns.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// of_hits[i] = values[slot[i]].
template <typename T>
void spread_one_by_one(const T* values, const std::int32_t* slot, T* of_hits, std::size_t first,
                       std::size_t end) {
    for (std::size_t i = first; i < end; ++i) of_hits[i] = values[slot[i]];
}

#if HWY_TARGET <= HWY_AVX3

/// One or two registers hold the values of all slots, mostly: a permutation, where a gather takes a
/// load for each lane. Goes on to the ends of registers.
template <typename T>
void spread_column(const T* values, std::size_t slot_count, const std::int32_t* slot, T* of_hits,
                   std::size_t first, std::size_t end) {
    static_assert(sizeof(T) == 4);
    const hn::FixedTag<T, 16> d;
    const hn::RebindToSigned<decltype(d)> di;
    constexpr std::size_t kLanes = 16;
    if (slot_count > kLanes) return spread_one_by_one(values, slot, of_hits, first, end);
    const auto table = hn::Load(d, values);
    for (std::size_t i = first / kLanes * kLanes; i < end; i += kLanes) {
        const auto which = hn::And(hn::Load(di, slot + i), hn::Set(di, 15));
        hn::Store(hn::TableLookupLanes(table, hn::IndicesFromVec(d, which)), d, of_hits + i);
    }
}

inline void spread_column(const double* values, std::size_t slot_count, const std::int32_t* slot,
                          double* of_hits, std::size_t first, std::size_t end) {
    const hn::FixedTag<double, 8> d;
    const hn::RebindToSigned<decltype(d)> di;
    const hn::Rebind<std::int32_t, decltype(d)> narrow;
    constexpr std::size_t kLanes = 8;
    if (slot_count > 2 * kLanes) return spread_one_by_one(values, slot, of_hits, first, end);
    const auto low = hn::Load(d, values);
    const auto high = hn::Load(d, values + kLanes);
    for (std::size_t i = first / kLanes * kLanes; i < end; i += kLanes) {
        const auto which = hn::PromoteTo(di, hn::Load(narrow, slot + i));
        const auto indices = hn::IndicesFromVec(d, hn::And(which, hn::Set(di, 7)));
        const auto in_high = hn::RebindMask(d, hn::Gt(which, hn::Set(di, 7)));
        hn::Store(hn::IfThenElse(in_high, hn::TableLookupLanes(high, indices),
                                 hn::TableLookupLanes(low, indices)),
                  d, of_hits + i);
    }
}

#else

template <typename T>
void spread_column(const T* values, std::size_t /*slot_count*/, const std::int32_t* slot,
                   T* of_hits, std::size_t first, std::size_t end) {
    spread_one_by_one(values, slot, of_hits, first, end);
}

#endif

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
