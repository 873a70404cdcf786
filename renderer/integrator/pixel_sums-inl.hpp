// SPDX-License-Identifier: MIT
// Sums of pixels side by side, a pixel a lane: CompensatedSum's, in the order of the samples.
//
// Read again for each instruction set, so that its guard is Highway's and not a pragma.
#if defined(COBBLE_PIXEL_SUMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef COBBLE_PIXEL_SUMS_INL
#undef COBBLE_PIXEL_SUMS_INL
#else
#define COBBLE_PIXEL_SUMS_INL
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "renderer/integrator/columns.hpp"
#include "renderer/wide/transpose-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D, class V>
HWY_INLINE hn::Vec<D> widened(D d, V v) {
    if constexpr (sizeof(hn::TFromV<V>) == sizeof(double)) {
        return v;
    } else {
        return hn::PromoteTo(d, v);
    }
}

/// `pixels` pixels of a channel, sample by sample: those of all pixels side by side. Lanes that are
/// left over repeat the last pixel.
template <typename T>
void turn(const T* colors, std::size_t samples, std::size_t pixels, std::size_t lanes, T* turned) {
    for (std::size_t p = 0; p < lanes; ++p) {
        const T* of_pixel = colors + (p < pixels ? p : pixels - 1) * samples;
        for (std::size_t k = 0; k < samples; ++k) turned[k * lanes + p] = of_pixel[k];
    }
}

/// CompensatedSum::add().
template <class D, class V>
HWY_INLINE void add_compensated(D d, V color, V& sum, V& rest) {
    // A sample's colour is a sum that began with 0: no negative zero.
    const V value = hn::Add(hn::Zero(d), color);
    const V next = hn::Add(sum, value);
    const V added = hn::Sub(next, sum);
    rest = hn::Add(rest, hn::Add(hn::Sub(sum, hn::Sub(next, added)), hn::Sub(value, added)));
    sum = next;
}

/// The sums of one sample each: nothing is lost.
template <typename T>
void begin_sums(const Columns3<T>& __restrict colors, std::size_t pixels,
                PixelSums& __restrict sums) {
    for (std::size_t i = 0; i < pixels; ++i) {
        sums.sum.set(i, math::Vec3d{} + colors.at(i).template to<double>());
        sums.rest.set(i, {});
    }
}

#if HWY_TARGET != HWY_SCALAR

/// Four samples of a channel of neighbouring pixels, `step` numbers from one pixel to the next:
/// those of all pixels side by side. Pixels behind the last one of `pixels` are that again.
template <class D, class V>
HWY_INLINE void turn_four(D d, const float* colors, std::size_t step, std::size_t pixels,
                          V* turned) {
    constexpr std::size_t kBlocks = hn::MaxLanes(D()) / 4;
    const auto row = [&](std::size_t p) HWY_ATTR {
        const auto of = [&](std::size_t pixel) HWY_ATTR {
            return colors + (pixel < pixels ? pixel : pixels - 1) * step;
        };
        if constexpr (kBlocks == 2) {
            const hn::Half<D> half;
            return hn::Combine(d, hn::LoadU(half, of(p + 4)), hn::LoadU(half, of(p)));
        } else {
            return hn::LoadU(d, of(p));
        }
    };
    transpose_fours(d, row(0), row(1), row(2), row(3), turned);
}

/// sum_pixels() of whole fours of samples, as many pixels side by side as `D` has lanes.
template <class D>
HWY_INLINE void sum_by_fours(D d, const Columns3<float>& colors, std::size_t samples,
                             std::size_t pixels, PixelSums& sums) {
    const hn::Rebind<float, D> of_color;
    const std::size_t lanes = hn::Lanes(d);
    const auto sum_channel = [&](const float* from, std::size_t left, double* to_sum,
                                 double* to_rest) HWY_ATTR {
        auto sum = hn::Zero(d);
        auto rest = hn::Zero(d);
        for (std::size_t k = 0; k < samples; k += 4) {
            hn::Vec<decltype(of_color)> turned[4];
            turn_four(of_color, from + k, samples, left, turned);
            for (const auto& color : turned) {
                add_compensated(d, hn::PromoteTo(d, color), sum, rest);
            }
        }
        hn::Store(sum, d, to_sum);
        hn::Store(rest, d, to_rest);
    };
    for (std::size_t first = 0; first < pixels; first += lanes) {
        const std::size_t at = first * samples;
        const std::size_t left = pixels - first;
        sum_channel(colors.x + at, left, sums.sum.x + first, sums.rest.x + first);
        sum_channel(colors.y + at, left, sums.sum.y + first, sums.rest.y + first);
        sum_channel(colors.z + at, left, sums.sum.z + first, sums.rest.z + first);
    }
}

#endif

/// Pixels side by side, for the sum of one is a chain of additions: as many as a register holds.
template <typename T>
void sum_pixels(const Columns3<T>& colors, std::size_t samples, std::size_t pixels,
                PixelSums& sums) {
    if (samples == 1) return begin_sums(colors, pixels, sums);
    const hn::CappedTag<double, 8> d;
#if HWY_TARGET != HWY_SCALAR
    if constexpr (sizeof(T) == sizeof(float) && hn::MaxLanes(d) >= 4) {
        if (samples % 4 == 0) {
            if (pixels > 4) return sum_by_fours(d, colors, samples, pixels, sums);
            return sum_by_fours(hn::CappedTag<double, 4>(), colors, samples, pixels, sums);
        }
    }
#endif
    const hn::Rebind<T, decltype(d)> of_color;
    const std::size_t lanes = hn::Lanes(d);
    alignas(kColumnAlignment) T x[8 * kBatchSize];
    alignas(kColumnAlignment) T y[8 * kBatchSize];
    alignas(kColumnAlignment) T z[8 * kBatchSize];
    for (std::size_t first = 0; first < pixels; first += lanes) {
        turn(colors.x + first * samples, samples, pixels - first, lanes, x);
        turn(colors.y + first * samples, samples, pixels - first, lanes, y);
        turn(colors.z + first * samples, samples, pixels - first, lanes, z);
        const auto zero = hn::Zero(d);
        auto sum_x = zero, sum_y = zero, sum_z = zero;
        auto rest_x = zero, rest_y = zero, rest_z = zero;
        for (std::size_t at = 0; at < samples * lanes; at += lanes) {
            add_compensated(d, widened(d, hn::Load(of_color, x + at)), sum_x, rest_x);
            add_compensated(d, widened(d, hn::Load(of_color, y + at)), sum_y, rest_y);
            add_compensated(d, widened(d, hn::Load(of_color, z + at)), sum_z, rest_z);
        }
        hn::Store(sum_x, d, sums.sum.x + first);
        hn::Store(sum_y, d, sums.sum.y + first);
        hn::Store(sum_z, d, sums.sum.z + first);
        hn::Store(rest_x, d, sums.rest.x + first);
        hn::Store(rest_y, d, sums.rest.y + first);
        hn::Store(rest_z, d, sums.rest.z + first);
    }
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
