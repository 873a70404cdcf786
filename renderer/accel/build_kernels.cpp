// SPDX-License-Identifier: MIT
#include "renderer/accel/build_kernels.hpp"

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

static_assert(sizeof(Extent<float>) == 8 * sizeof(float));

/// The eight numbers of an Extent, in as many lanes as there are.
using BoxLanes = hn::CappedTag<float, 8>;
using Box = hn::Vec<BoxLanes>;
inline constexpr std::size_t kBoxStep = hn::MaxLanes(BoxLanes());
inline constexpr std::size_t kBoxParts = 8 / kBoxStep;

HWY_INLINE const float* numbers(const Extent<float>& extent) { return extent.lo; }
HWY_INLINE float* numbers(Extent<float>& extent) { return extent.lo; }

HWY_INLINE float* numbers(BuildItem<float>& item) {
    return reinterpret_cast<float*>(&item);  // all that it is
}

HWY_INLINE Box load(const Extent<float>& extent, std::size_t part) {
    return hn::Load(BoxLanes(), numbers(extent) + part * kBoxStep);
}

/// Twice the middle and its negative.
HWY_INLINE Box middle_twice(const Extent<float>& extent, std::size_t part) {
    const BoxLanes d;
    const Box own = load(extent, part);
#if HWY_TARGET != HWY_SCALAR
    if constexpr (kBoxParts == 1) return hn::Sub(own, hn::ConcatLowerUpper(d, own, own));
#endif
    return hn::Sub(own, hn::Load(d, numbers(extent) + ((part * kBoxStep) ^ 4)));
}

/// Grows by what is added, in lanes.
struct Growing {
    Box parts[kBoxParts];

    HWY_INLINE void clear() {
        for (Box& part : parts) part = hn::Set(BoxLanes(), std::numeric_limits<float>::infinity());
    }
    HWY_INLINE void add(std::size_t part, Box box) { parts[part] = hn::Min(parts[part], box); }
    HWY_INLINE void add(const Extent<float>& extent) {
        for (std::size_t part = 0; part < kBoxParts; ++part) add(part, load(extent, part));
    }
    HWY_INLINE void store(Extent<float>& to) const {
        for (std::size_t part = 0; part < kBoxParts; ++part) {
            hn::Store(parts[part], BoxLanes(), numbers(to) + part * kBoxStep);
        }
    }
};

void measure(const BuildItem<float>* items, std::size_t count, ItemExtents<float>& out) {
    Growing box;
    Growing middles;
    box.clear();
    middles.clear();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t part = 0; part < kBoxParts; ++part) {
            box.add(part, load(items[i].extent(), part));
            middles.add(part, middle_twice(items[i].extent(), part));
        }
    }
    box.store(out.box);
    middles.store(out.middles);
}

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void fill(const BuildItem<float>* items, std::uint32_t count,
                     const Binning<float>& binning, Bins<float>& bins) {
    plain::clear_bins(binning.bins, bins);
    for (std::uint32_t i = 0; i < count; ++i) plain::put(items[i], binning, bins);
}

HWY_INLINE BinSplit best_split(const Bins<float>& bins, std::uint32_t count, float unit) {
    return plain::best_split(bins, count, unit);
}

void sort(const BuildItem<float>* items, std::uint32_t count, const Binning<float>& binning,
          const Cells<float>& cells) {
    plain::sort_into_cells(items, count, binning, cells);
}

#else

/// A number for each axis.
using AxisLanes = hn::CappedTag<float, 4>;
using Axes = hn::Vec<AxisLanes>;
using CountLanes = hn::RebindToSigned<AxisLanes>;

HWY_INLINE void clear(std::uint32_t count, Bins<float>& bins) {
    const BoxLanes d;
    const auto infinity = hn::Set(d, std::numeric_limits<float>::infinity());
    const hn::RebindToUnsigned<AxisLanes> du;
    for (std::uint32_t b = 0; b < count; ++b) {
        for (std::size_t i = 0; i < 3 * 8; i += kBoxStep) {
            hn::Store(infinity, d, numbers(bins.extents[b][0]) + i);
        }
        hn::Store(hn::Zero(du), du, bins.counts[b]);
    }
}

/// Where the middle of an item lies.
struct BinScale {
    Axes from, scale, last;

    explicit HWY_INLINE BinScale(const Binning<float>& binning) {
        const AxisLanes d;
        from = hn::LoadU(d, binning.lo);
        scale = hn::LoadU(d, binning.per_unit);
        last = hn::Set(d, binning.last);
    }
    /// Along all axes, in [1, 2). NaN goes to the last bin, as in Binning.
    HWY_INLINE hn::Vec<hn::RebindToUnsigned<AxisLanes> > bits(const Extent<float>& item) const {
        const AxisLanes d;
        const hn::RebindToUnsigned<AxisLanes> du;
        const Axes middle = hn::Sub(hn::Load(d, item.lo), hn::Load(d, item.minus_hi));
        const Axes at = hn::Add(hn::Mul(hn::Sub(middle, from), scale), hn::Set(d, 1.0F));
        return hn::BitCast(du, hn::IfThenElse(hn::Lt(at, last), at, last));
    }
    /// The bins, in bytes of Bins::counts.
    HWY_INLINE void find(const Extent<float>& item, std::uint32_t* bytes) const {
        const hn::RebindToUnsigned<AxisLanes> du;
        // Four bits behind the point, and as many zeros behind them.
        constexpr int kShift = 23 - 4 - 4;
        static_assert(kMostBins == 1U << 4 && sizeof(Bins<float>::counts[0]) == 1U << 4);
        hn::Store(hn::And(hn::ShiftRight<kShift>(bits(item)), hn::Set(du, 0xf0U)), du, bytes);
    }
    /// The cell of a grid.
    [[nodiscard]] HWY_INLINE std::uint32_t cell(const Extent<float>& item) const {
        const hn::RebindToUnsigned<AxisLanes> du;
        alignas(16) std::uint32_t along[4];
        const auto places = hn::ShiftRight<23 - static_cast<int>(kCellBits)>(bits(item));
        hn::Store(hn::And(places, hn::Set(du, kCellsAlong - 1)), du, along);
        return along[0] | along[1] << kCellBits | along[2] << (2 * kCellBits);
    }
};

HWY_INLINE void put(const BuildItem<float>& item, const BinScale& scale, Bins<float>& bins) {
    alignas(16) std::uint32_t bin[4];
    scale.find(item.extent(), bin);
    Box box[kBoxParts];
    for (std::size_t part = 0; part < kBoxParts; ++part) box[part] = load(item.extent(), part);
    constexpr std::size_t kRatio = 8;
    static_assert(sizeof(bins.extents) == kRatio * sizeof(bins.counts));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t bytes = bin[axis];
        *reinterpret_cast<std::uint32_t*>(reinterpret_cast<char*>(&bins.counts[0][axis]) + bytes) +=
            1;
        auto* const into = reinterpret_cast<float*>(
            reinterpret_cast<char*>(&bins.extents[0][axis]) + bytes * kRatio);
        for (std::size_t part = 0; part < kBoxParts; ++part) {
            const BoxLanes d;
            float* const at = into + part * kBoxStep;
            hn::Store(hn::Min(box[part], hn::Load(d, at)), d, at);
        }
    }
}

HWY_INLINE void fill(const BuildItem<float>* items, std::uint32_t count,
                     const Binning<float>& binning, Bins<float>& bins) {
    clear(binning.bins, bins);
    const BinScale scale(binning);
    // Neighbours often go to one bin, and the second waits for the first: of many items every
    // other one goes to bins of its own.
    constexpr std::uint32_t kMany = 128;
    if (count < kMany) {
        for (std::uint32_t i = 0; i < count; ++i) put(items[i], scale, bins);
        return;
    }
    Bins<float> others;
    clear(binning.bins, others);
    for (std::uint32_t i = 0; i + 1 < count; i += 2) {
        put(items[i], scale, bins);
        put(items[i + 1], scale, others);
    }
    if (count % 2 != 0) put(items[count - 1], scale, bins);
    for (std::uint32_t b = 0; b < binning.bins; ++b) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Growing both;
            both.clear();
            both.add(others.extents[b][axis]);
            both.add(bins.extents[b][axis]);
            both.store(bins.extents[b][axis]);
            bins.counts[b][axis] += others.counts[b][axis];
        }
    }
}

/// Low corners and negated high ones: lengths with the wrong sign.
template <std::size_t kParts>
HWY_INLINE Axes sum_of_corners(const Box (&parts)[kParts]) {
    if constexpr (kParts == 1) {
        const AxisLanes half;
        return hn::Add(hn::LowerHalf(half, parts[0]), hn::UpperHalf(half, parts[0]));
    } else {
        return hn::Add(parts[0], parts[1]);
    }
}

/// As plain::sort_into_cells.
void sort(const BuildItem<float>* items, std::uint32_t count, const Binning<float>& binning,
          const Cells<float>& cells) {
    const BinScale scale(binning);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Extent<float>& item = items[i].extent();
        const std::uint32_t cell = scale.cell(item);
        cells.cell_of[i] = static_cast<std::uint16_t>(cell);
        const bool first = cells.counts[cell] == 0;
        cells.counts[cell] += 1;
        float* const box = numbers(cells.extents[cell].box);
        float* const middles = numbers(cells.extents[cell].middles);
        const BoxLanes d;
        for (std::size_t part = 0; part < kBoxParts; ++part) {
            const std::size_t at = part * kBoxStep;
            const Box own = load(item, part);
            const Box twice = middle_twice(item, part);
            hn::Store(first ? own : hn::Min(hn::Load(d, box + at), own), d, box + at);
            hn::Store(first ? twice : hn::Min(hn::Load(d, middles + at), twice), d, middles + at);
        }
    }
}

/// Sides of bins along all three axes at once, a lane each: x, y and z of the low corners, and of
/// the negated high ones in the other half of the lanes, or in the second part.
struct Sides {
    Box of[3][kBoxParts];

    HWY_INLINE void clear() {
        for (auto& coordinate : of) {
            for (Box& part : coordinate) {
                part = hn::Set(BoxLanes(), std::numeric_limits<float>::infinity());
            }
        }
    }
    HWY_INLINE void add(const Sides& other) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t part = 0; part < kBoxParts; ++part) {
                of[i][part] = hn::Min(of[i][part], other.of[i][part]);
            }
        }
    }
    /// From those of a bin along each axis.
    HWY_INLINE void gather(const Extent<float>* extents) {
        const BoxLanes d;
        for (std::size_t part = 0; part < kBoxParts; ++part) {
            const Box a = load(extents[0], part);
            const Box b = load(extents[1], part);
            const Box c = load(extents[2], part);
            const Box ac = hn::InterleaveLower(d, a, c);
            const Box bc = hn::InterleaveLower(d, b, c);
            of[0][part] = hn::InterleaveLower(d, ac, bc);
            of[1][part] = hn::InterleaveUpper(d, ac, bc);
            of[2][part] =
                hn::InterleaveLower(d, hn::InterleaveUpper(d, a, c), hn::InterleaveUpper(d, b, c));
        }
    }
    HWY_INLINE void store(float* to) const {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t part = 0; part < kBoxParts; ++part) {
                hn::Store(of[i][part], BoxLanes(), to + i * 8 + part * kBoxStep);
            }
        }
    }
    HWY_INLINE void load_all(const float* from) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t part = 0; part < kBoxParts; ++part) {
                of[i][part] = hn::Load(BoxLanes(), from + i * 8 + part * kBoxStep);
            }
        }
    }
    /// As plain::cost.
    [[nodiscard]] HWY_INLINE Axes cost(Axes unit, hn::Vec<CountLanes> counts) const {
        const Axes x = hn::Mul(sum_of_corners(of[0]), unit);
        const Axes y = hn::Mul(sum_of_corners(of[1]), unit);
        const Axes z = hn::Mul(sum_of_corners(of[2]), unit);
        const Axes area = hn::Add(hn::Add(hn::Mul(x, y), hn::Mul(y, z)), hn::Mul(z, x));
        const auto most = hn::Add(counts, hn::Set(CountLanes(), 3));
        return hn::Mul(area, hn::ConvertTo(AxisLanes(), hn::ShiftRight<2>(most)));
    }
};

/// As plain::best_split.
HWY_INLINE BinSplit best_split(const Bins<float>& bins, std::uint32_t count, float longest) {
    const AxisLanes d;
    const CountLanes di;
    const Axes unit = hn::Set(d, longest);
    alignas(32) float gathered[kMostBins][3 * 8];
    alignas(16) float right_cost[kMostBins][4];
    Sides side;
    side.clear();
    auto items = hn::Zero(di);
    const auto counts = [&](std::uint32_t bin) HWY_ATTR {
        const hn::RebindToUnsigned<AxisLanes> du;
        return hn::BitCast(di, hn::Load(du, bins.counts[bin]));
    };
    for (std::uint32_t bin = count - 1; bin > 0; --bin) {
        Sides own;
        own.gather(bins.extents[bin]);
        own.store(gathered[bin]);
        side.add(own);
        items = hn::Add(items, counts(bin));
        hn::Store(side.cost(unit, items), d, right_cost[bin]);
    }
    side.gather(bins.extents[0]);
    items = counts(0);
    Axes best = hn::Set(d, std::numeric_limits<float>::infinity());
    auto at = hn::Zero(di);
    for (std::uint32_t bin = 1; bin < count; ++bin) {
        const Axes cost = hn::Add(side.cost(unit, items), hn::Load(d, right_cost[bin]));
        const auto better = hn::Lt(cost, best);
        best = hn::IfThenElse(better, cost, best);
        at = hn::IfThenElse(hn::RebindMask(di, better), hn::Set(di, static_cast<std::int32_t>(bin)),
                            at);
        Sides own;
        own.load_all(gathered[bin]);
        side.add(own);
        items = hn::Add(items, counts(bin));
    }
    alignas(16) float costs[4];
    alignas(16) std::int32_t places[4];
    hn::Store(best, d, costs);
    hn::Store(at, di, places);
    std::size_t axis = costs[1] < costs[0] ? 1 : 0;
    if (costs[2] < costs[axis]) axis = 2;
    return {axis, static_cast<std::uint32_t>(places[axis])};
}

#endif

/// As plain::part.
HWY_INLINE void part(const BuildItem<float>* items, std::uint32_t count,
                     const Binning<float>& binning, const BinSplit& split, BuildItem<float>* to,
                     Halves<float>& halves) {
    const float from = binning.lo[split.axis];
    const float scale = binning.per_unit[split.axis];
    const float limit = Binning<float>::begin(split.bin);
    const BoxLanes d;
    const auto infinity = hn::Set(d, std::numeric_limits<float>::infinity());
    Growing left_middles;
    Growing right_middles;
    left_middles.clear();
    right_middles.clear();
    // Every item is written to both sides, and counts on one: no branch to guess.
    float* left = numbers(to[0]);
    float* right = numbers(to[count - 1]);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Extent<float>& item = items[i].extent();
        const float twice_middle = item.lo[split.axis] - item.minus_hi[split.axis];
        const float at = (twice_middle - from) * scale + 1;
        const bool first = at < limit;
        const auto to_left = hn::Lt(hn::Set(d, at), hn::Set(d, limit));
        for (std::size_t part = 0; part < kBoxParts; ++part) {
            const Box twice = middle_twice(item, part);
            left_middles.add(part, hn::IfThenElse(to_left, twice, infinity));
            right_middles.add(part, hn::IfThenElse(to_left, infinity, twice));
            const Box own = load(item, part);
            hn::Store(own, d, left + part * kBoxStep);
            hn::Store(own, d, right + part * kBoxStep);
        }
        left += first ? 8 : 0;
        right -= first ? 0 : 8;
    }
    halves.left_count = static_cast<std::uint32_t>((left - numbers(to[0])) / 8);
    left_middles.store(halves.left.middles);
    right_middles.store(halves.right.middles);
}

void split(const BuildItem<float>* items, std::uint32_t count, const ItemExtents<float>& extents,
           std::uint32_t bin_count, BuildItem<float>* to, Halves<float>& halves) {
    const Binning<float> binning(extents.middles, bin_count);
    Bins<float> bins;
    fill(items, count, binning, bins);
    const BinSplit split = best_split(bins, bin_count, area_unit(extents.box));
    halves.left_count = 0;
    if (split.bin == 0) return;
    Growing side;
    side.clear();
    for (std::uint32_t b = 0; b < split.bin; ++b) side.add(bins.extents[b][split.axis]);
    side.store(halves.left.box);
    side.clear();
    for (std::uint32_t b = split.bin; b < bin_count; ++b) side.add(bins.extents[b][split.axis]);
    side.store(halves.right.box);
    part(items, count, binning, split, to, halves);
}

}  // namespace cobble::renderer::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cobble::renderer {

HWY_EXPORT(measure);
HWY_EXPORT(split);
HWY_EXPORT(sort);

template <>
ItemExtents<float> measure_items(const BuildItem<float>* items, std::size_t count) {
    ItemExtents<float> extents;
    HWY_DYNAMIC_DISPATCH(measure)(items, count, extents);
    return extents;
}

template <>
void sort_into_cells(const BuildItem<float>* items, std::uint32_t count,
                     const Extent<float>& middles, const Cells<float>& cells) {
    const Binning<float> binning(middles, kMostBins);
    HWY_DYNAMIC_DISPATCH(sort)(items, count, binning, cells);
}

template <>
Halves<float> split_items(const BuildItem<float>* items, std::uint32_t count,
                          const ItemExtents<float>& extents, std::uint32_t bins,
                          BuildItem<float>* to) {
    Halves<float> halves;
    HWY_DYNAMIC_DISPATCH(split)(items, count, extents, bins, to, halves);
    return halves;
}

}  // namespace cobble::renderer
#endif
