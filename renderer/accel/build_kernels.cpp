// SPDX-License-Identifier: MIT
#include "renderer/accel/build_kernels.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/accel/build_kernels.cpp"
#include <hwy/foreach_target.h>
// Behind foreach_target.h, as Highway wants it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cobble::renderer::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

static_assert(sizeof(BuildItem<float>) == 32);

/// Three numbers and one without meaning; on machines without such registers one at a time.
template <typename Each>
HWY_INLINE void each_part(Each each) {
    using D = hn::CappedTag<float, 4>;
    for (std::size_t part = 0; part < 4; part += hn::MaxLanes(D())) each(D(), part);
}

/// The low and high corner of an item. What is read beyond them is the item's own: behind the low
/// one a number, behind the high one bits that are none.
HWY_INLINE const float* low(const BuildItem<float>& item) { return &item.bounds.lo.x; }
HWY_INLINE const float* high(const BuildItem<float>& item) { return &item.bounds.hi.x; }

/// The bits behind the high corner left out: as a number they may be so small that arithmetic with
/// them takes a hundred times as long.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V clean_high(D d, const BuildItem<float>& item, std::size_t part) {
    alignas(16) static constexpr std::uint32_t kCorner[4] = {~0U, ~0U, ~0U, 0};
    const hn::RebindToUnsigned<D> du;
    return hn::And(hn::LoadU(d, high(item) + part), hn::BitCast(d, hn::Load(du, kCorner + part)));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V middle(D d, const BuildItem<float>& item, std::size_t part) {
    const auto half = hn::Set(d, 0.5F);
    return hn::Add(hn::Mul(hn::LoadU(d, low(item) + part), half),
                   hn::Mul(clean_high(d, item, part), half));
}

/// Eight numbers as in a Bin, in as many lanes as there are.
using BoxLanes = hn::CappedTag<float, 8>;
inline constexpr std::size_t kBoxStep = hn::MaxLanes(BoxLanes());
inline constexpr std::size_t kBoxParts = 8 / kBoxStep;

HWY_INLINE hn::Vec<BoxLanes> box_of(const BuildItem<float>& item, std::size_t part) {
    const BoxLanes d;
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kBoxStep == 8) {
        const hn::Half<BoxLanes> half;
        return hn::Combine(d, hn::Neg(hn::LoadU(half, high(item))), hn::LoadU(half, low(item)));
    }
#endif
    return part < 4 ? hn::LoadU(d, low(item) + part)
                    : hn::Neg(hn::LoadU(d, high(item) + (part - 4)));
}

/// The same of an item's middle.
HWY_INLINE hn::Vec<BoxLanes> middle_twice(const BuildItem<float>& item, std::size_t part) {
    const BoxLanes d;
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kBoxStep == 8) {
        const hn::Half<BoxLanes> half;
        const auto m = middle(half, item, 0);
        return hn::Combine(d, hn::Neg(m), m);
    }
#endif
    return part < 4 ? middle(d, item, part) : hn::Neg(middle(d, item, part - 4));
}

BoxBounds<float> bounds_of(const float* numbers) {
    return {{numbers[0], numbers[1], numbers[2]}, {-numbers[4], -numbers[5], -numbers[6]}};
}

HWY_INLINE std::uint32_t kind_bit(const BuildItem<float>& item) {
    return 1U << static_cast<std::uint32_t>(item.kind);
}

/// What some items span, in lanes.
struct Side {
    using V = hn::Vec<BoxLanes>;
    V box[kBoxParts];
    V middle[kBoxParts];
    std::uint32_t kinds = 0;

    HWY_INLINE void clear() {
        for (std::size_t part = 0; part < kBoxParts; ++part) {
            box[part] = hn::Set(BoxLanes(), std::numeric_limits<float>::infinity());
            middle[part] = box[part];
        }
    }
    HWY_INLINE void add(std::size_t part, V of_box, V of_middle) {
        box[part] = hn::Min(box[part], of_box);
        middle[part] = hn::Min(middle[part], of_middle);
    }
    HWY_INLINE ItemExtents<float> extents() const {
        alignas(32) float boxes[8];
        alignas(32) float middles[8];
        for (std::size_t part = 0; part < kBoxParts; ++part) {
            hn::Store(box[part], BoxLanes(), boxes + part * kBoxStep);
            hn::Store(middle[part], BoxLanes(), middles + part * kBoxStep);
        }
        return {bounds_of(boxes), bounds_of(middles), kinds};
    }
};

void measure(const BuildItem<float>* items, std::size_t count, ItemExtents<float>& out) {
    Side all;
    all.clear();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t part = 0; part < kBoxParts; ++part) {
            all.add(part, box_of(items[i], part * kBoxStep),
                    middle_twice(items[i], part * kBoxStep));
        }
        all.kinds |= kind_bit(items[i]);
    }
    out = all.extents();
}

HWY_INLINE float* numbers(Bin<float>& bin) { return bin.lo; }
static_assert(sizeof(Bin<float>) == 8 * sizeof(float));

/// Where the middle of an item lies, in bins.
struct BinScale {
    alignas(16) float from[4];
    alignas(16) float scale[4];
    float bins;

    explicit BinScale(const Binning<float>& binning)
        : from{binning.lo.x, binning.lo.y, binning.lo.z, 0},
          scale{binning.per_unit.x, binning.per_unit.y, binning.per_unit.z, 0},
          bins(static_cast<float>(binning.bins)) {}

    /// Of all three axes. NaN, of an axis that can not be binned, goes to the last one.
    HWY_INLINE void find(const BuildItem<float>& item, std::int32_t* bin) const {
        each_part([&](auto d, std::size_t part) HWY_ATTR {
            const hn::RebindToSigned<decltype(d)> di;
            const auto at = hn::Mul(hn::Sub(middle(d, item, part), hn::Load(d, from + part)),
                                    hn::Load(d, scale + part));
            const auto inside = hn::Lt(at, hn::Set(d, bins));
            hn::Store(hn::ConvertTo(di, hn::IfThenElse(inside, at, hn::Set(d, bins - 1))), di,
                      bin + part);
        });
    }
};

HWY_INLINE void put(const BuildItem<float>& item, const BinScale& scale, Bins<float>& bins) {
    alignas(16) std::int32_t bin[4];
    scale.find(item, bin);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        bins.counts[axis][static_cast<std::uint32_t>(bin[axis])] += 1;
    }
    const BoxLanes d;
    for (std::size_t part = 0; part < 8; part += kBoxStep) {
        const auto box = box_of(item, part);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float* const into =
                numbers(bins.bins[axis][static_cast<std::uint32_t>(bin[axis])]) + part;
            hn::Store(hn::Min(box, hn::Load(d, into)), d, into);
        }
    }
}

void fill(const BuildItem<float>* items, std::size_t count, const Binning<float>& binning,
          Bins<float>& bins) {
    clear_bins(binning.bins, bins);
    const BinScale scale(binning);
    // Neighbours often go to one bin, and the second waits for the first: of many items every
    // other one goes to bins of its own.
    constexpr std::size_t kMany = 128;
    if (count < kMany) {
        for (std::size_t i = 0; i < count; ++i) put(items[i], scale, bins);
        return;
    }
    Bins<float> others;
    clear_bins(binning.bins, others);
    for (std::size_t i = 0; i + 1 < count; i += 2) {
        put(items[i], scale, bins);
        put(items[i + 1], scale, others);
    }
    if (count % 2 != 0) put(items[count - 1], scale, bins);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::uint32_t b = 0; b < binning.bins; ++b) {
            const BoxLanes d;
            for (std::size_t part = 0; part < 8; part += kBoxStep) {
                float* const into = numbers(bins.bins[axis][b]) + part;
                const float* const from = numbers(others.bins[axis][b]) + part;
                hn::Store(hn::Min(hn::Load(d, from), hn::Load(d, into)), d, into);
            }
            bins.counts[axis][b] += others.counts[axis][b];
        }
    }
}

void split(BuildItem<float>* items, std::size_t count, const Binning<float>& binning,
           const BinSplit& where, BuildItem<float>* scratch, Halves<float>& out) {
    const float from = binning.lo[where.axis];
    const float scale = binning.per_unit[where.axis];
    // The first bins' middles lie below a whole number: no need to round.
    const auto end = static_cast<float>(where.bin);
    const BoxLanes d;
    const auto infinity = hn::Set(d, std::numeric_limits<float>::infinity());
    Side sides[2];
    for (Side& side : sides) side.clear();
    std::size_t left = 0;
    std::size_t right = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const BuildItem<float>& item = items[i];
        const float mid = low(item)[where.axis] * 0.5F + high(item)[where.axis] * 0.5F;
        const float at = (mid - from) * scale;
        const bool first = at < end;
        const auto to_left = hn::Lt(hn::Set(d, at), hn::Set(d, end));
        for (std::size_t part = 0; part < kBoxParts; ++part) {
            const auto box = box_of(item, part * kBoxStep);
            const auto twice = middle_twice(item, part * kBoxStep);
            sides[0].add(part, hn::IfThenElse(to_left, box, infinity),
                         hn::IfThenElse(to_left, twice, infinity));
            sides[1].add(part, hn::IfThenElse(to_left, infinity, box),
                         hn::IfThenElse(to_left, infinity, twice));
        }
        sides[0].kinds |= first ? kind_bit(item) : 0;
        sides[1].kinds |= first ? 0 : kind_bit(item);
        const BuildItem<float> copy = item;
        items[left] = copy;
        scratch[right] = copy;
        left += first ? 1 : 0;
        right += first ? 0 : 1;
    }
    std::copy_n(scratch, right, items + left);
    out.left_count = static_cast<std::uint32_t>(left);
    out.left = sides[0].extents();
    out.right = sides[1].extents();
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cobble::renderer {

HWY_EXPORT(measure);
HWY_EXPORT(fill);
HWY_EXPORT(split);

template <>
ItemExtents<float> measure_items(const BuildItem<float>* items, std::size_t count) {
    ItemExtents<float> extents;
    HWY_DYNAMIC_DISPATCH(measure)(items, count, extents);
    return extents;
}

template <>
void fill_bins(const BuildItem<float>* items, std::size_t count, const Binning<float>& binning,
               Bins<float>& bins) {
    HWY_DYNAMIC_DISPATCH(fill)(items, count, binning, bins);
}

template <>
Halves<float> split_by_bin(BuildItem<float>* items, std::size_t count,
                           const Binning<float>& binning, BinSplit where,
                           BuildItem<float>* scratch) {
    Halves<float> halves;
    HWY_DYNAMIC_DISPATCH(split)(items, count, binning, where, scratch, halves);
    return halves;
}

}  // namespace cobble::renderer
#endif
