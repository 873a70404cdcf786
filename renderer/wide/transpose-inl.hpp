// SPDX-License-Identifier: MIT
// Rows of numbers in registers, turned into columns.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_TRANSPOSE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_TRANSPOSE_INL
#undef COBBLE_TRANSPOSE_INL
#else
#define COBBLE_TRANSPOSE_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

/// In each block of four floats on its own: to[i] has number i of all four rows.
template <class D, class V>
HWY_INLINE void transpose_fours(D d, V r0, V r1, V r2, V r3, V* to) {
    const hn::Repartition<double, D> pairs;
    const auto low = hn::BitCast(pairs, hn::InterleaveLower(d, r0, r1));
    const auto low2 = hn::BitCast(pairs, hn::InterleaveLower(d, r2, r3));
    const auto high = hn::BitCast(pairs, hn::InterleaveUpper(d, r0, r1));
    const auto high2 = hn::BitCast(pairs, hn::InterleaveUpper(d, r2, r3));
    to[0] = hn::BitCast(d, hn::InterleaveLower(pairs, low, low2));
    to[1] = hn::BitCast(d, hn::InterleaveUpper(pairs, low, low2));
    to[2] = hn::BitCast(d, hn::InterleaveLower(pairs, high, high2));
    to[3] = hn::BitCast(d, hn::InterleaveUpper(pairs, high, high2));
}

#endif

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
