// SPDX-License-Identifier: MIT
// Places in pixels for the box filter: sobol_point() of neighbouring samples, a lane each.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_PIXEL_PLACES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_PIXEL_PLACES_INL
#undef COBBLE_PIXEL_PLACES_INL
#else
#define COBBLE_PIXEL_PLACES_INL
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "renderer/integrator/columns.hpp"
#include "renderer/sampling/sobol.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR

inline void place_in_pixels(CameraColumns& s) {
    for (std::size_t r = 0; r < s.run_count; ++r) {
        const PixelRun& run = s.runs[r];
        for (std::uint32_t i = 0; i < run.count; ++i) {
            const Uniform2 u = sobol_point_of_reversed(reverse_bits(run.first + i), run.seeds);
            s.x[run.begin + i] = (run.x + 0.5) + (u.x - 0.5);
            s.y[run.begin + i] = (run.y + 0.5) + (u.y - 0.5);
        }
    }
}

#else

/// reverse_bits(): the bytes of each number turned around, then the two halves of each byte.
template <class D, class V>
HWY_INLINE V reversed(D d, V v) {
    const hn::Repartition<std::uint8_t, D> bytes;
    alignas(16) static constexpr std::uint8_t kOtherEnd[16] = {3,  2,  1, 0, 7,  6,  5,  4,
                                                               11, 10, 9, 8, 15, 14, 13, 12};
    alignas(16) static constexpr std::uint8_t kLow[16] = {0x00, 0x80, 0x40, 0xc0, 0x20, 0xa0,
                                                          0x60, 0xe0, 0x10, 0x90, 0x50, 0xd0,
                                                          0x30, 0xb0, 0x70, 0xf0};
    alignas(16) static constexpr std::uint8_t kHigh[16] = {0x0, 0x8, 0x4, 0xc, 0x2, 0xa, 0x6, 0xe,
                                                           0x1, 0x9, 0x5, 0xd, 0x3, 0xb, 0x7, 0xf};
    const auto half = hn::Set(d, 0x0f0f0f0fU);
    const auto turned = hn::BitCast(
        d, hn::TableLookupBytes(hn::BitCast(bytes, v), hn::LoadDup128(bytes, kOtherEnd)));
    const auto look_up = [&](const std::uint8_t* table, V halves) HWY_ATTR {
        return hn::BitCast(
            d, hn::TableLookupBytes(hn::LoadDup128(bytes, table), hn::BitCast(bytes, halves)));
    };
    return hn::Or(look_up(kLow, hn::And(turned, half)),
                  look_up(kHigh, hn::And(hn::ShiftRight<4>(turned), half)));
}

/// laine_karras().
template <class D, class V>
HWY_INLINE V scrambled(D d, V v, std::uint32_t seed) {
    v = hn::Add(v, hn::Set(d, seed));
    for (const std::uint32_t factor : kLaineKarras) {
        v = hn::Xor(v, hn::Mul(v, hn::Set(d, factor)));
    }
    return v;
}

/// times_pascal().
template <class D, class V>
HWY_INLINE V with_pascal(D d, V v) {
    v = hn::Xor(v, hn::And(hn::ShiftRight<1>(v), hn::Set(d, 0x55555555U)));
    v = hn::Xor(v, hn::And(hn::ShiftRight<2>(v), hn::Set(d, 0x33333333U)));
    v = hn::Xor(v, hn::And(hn::ShiftRight<4>(v), hn::Set(d, 0x0f0f0f0fU)));
    v = hn::Xor(v, hn::And(hn::ShiftRight<8>(v), hn::Set(d, 0x00ff00ffU)));
    return hn::Xor(v, hn::ShiftRight<16>(v));
}

/// sample_filter() of a coordinate of a Sobol point, from the pixel's corner: less a half it is a
/// signed number of 32 bits, so that all is exact but the last sum.
template <class D, class V>
HWY_INLINE void store_places(D d, V coordinate, std::uint32_t corner, double* to) {
    const hn::RebindToSigned<D> signs;
    const hn::Half<decltype(signs)> half;
    const hn::Rebind<double, decltype(half)> wide;
    const auto less_half = hn::BitCast(signs, hn::Xor(coordinate, hn::Set(d, 0x80000000U)));
    const auto middle = hn::Set(wide, corner + 0.5);
    const auto store = [&](auto part, double* there) HWY_ATTR {
        const auto offset = hn::Mul(hn::PromoteTo(wide, part), hn::Set(wide, kTwoToMinus32));
        hn::StoreU(hn::Add(middle, offset), wide, there);
    };
    store(hn::LowerHalf(half, less_half), to);
    store(hn::UpperHalf(half, less_half), to + hn::Lanes(half));
}

/// sobol_point(), at most kMost samples at once.
template <std::size_t kMost>
void place_runs(CameraColumns& s) {
    const hn::CappedTag<std::uint32_t, kMost> d;
    // Loaded: g++ makes hn::Iota() of a number for each lane through memory, and waits for it.
    alignas(kColumnAlignment) static constexpr std::uint32_t kLanesInOrder[16] = {
        0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    for (std::size_t r = 0; r < s.run_count; ++r) {
        const PixelRun& run = s.runs[r];
        for (std::uint32_t i = 0; i < run.count; i += static_cast<std::uint32_t>(hn::Lanes(d))) {
            const auto index = hn::Add(hn::Set(d, run.first + i), hn::Load(d, kLanesInOrder));
            const auto order = reversed(d, scrambled(d, reversed(d, index), run.seeds.order));
            const auto x = reversed(d, scrambled(d, order, run.seeds.x));
            const auto y = reversed(d, scrambled(d, with_pascal(d, order), run.seeds.y));
            store_places(d, x, run.x, s.x + run.begin + i);
            store_places(d, y, run.y, s.y + run.begin + i);
        }
    }
}

inline void place_in_pixels(CameraColumns& s) {
    // Runs are of one length, but for the last one.
    const std::uint32_t length = s.runs[0].count;
    if (length <= 4) return place_runs<4>(s);
    if (length <= 8) return place_runs<8>(s);
    place_runs<16>(s);
}

#endif

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
