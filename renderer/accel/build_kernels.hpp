// SPDX-License-Identifier: MIT
// The loops over items that building a tree spends its time in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/accel/builder.hpp"

namespace cobble::renderer {

/// What a range of items spans.
template <typename T>
struct ItemExtents {
    BoxBounds<T> bounds;
    BoxBounds<T> middles;     ///< of the middles of the items' boxes
    std::uint32_t kinds = 0;  ///< a bit for each kind that is there
};

/// Maps middles to bins; the same bin for the same middle wherever it is asked.
template <typename T>
struct Binning {
    math::Vec3<T> lo, per_unit;  ///< per_unit is 0 along an axis that can not be binned
    std::uint32_t bins;

    /// `bins`: at most kMostBins.
    Binning(const BoxBounds<T>& middles, std::uint32_t count) : lo(middles.lo), bins(count) {
        for (std::size_t a = 0; a < 3; ++a) {
            const T scale = static_cast<T>(bins) / (middles.hi[a] - middles.lo[a]);
            per_unit[a] = scale <= std::numeric_limits<T>::max() ? scale : T(0);
        }
    }
    [[nodiscard]] std::uint32_t bin(math::Vec3<T> middle, std::size_t axis) const {
        const T at = (middle[axis] - lo[axis]) * per_unit[axis];
        return at < static_cast<T>(bins) ? static_cast<std::uint32_t>(at) : bins - 1;
    }
};

inline constexpr std::uint32_t kMostBins = 16;

/// What the items of a bin span, by x, y, z and a number without meaning. The high corner is
/// negated, so that the least is looked for in all eight.
template <typename T>
struct alignas(32) Bin {
    T lo[4], minus_hi[4];
};
template <typename T>
struct Bins {
    Bin<T> bins[3][kMostBins];
    std::uint32_t counts[3][kMostBins];
};

template <typename T>
math::Vec3<T> middle_of(const BoxBounds<T>& b) {
    return b.lo * T(0.5) + b.hi * T(0.5);
}

/// Where items go that are split: those of bins below `bin` along `axis` come first.
struct BinSplit {
    std::size_t axis = 0;
    std::uint32_t bin = 0;
};

/// What a range was split into.
template <typename T>
struct Halves {
    std::uint32_t left_count = 0;
    ItemExtents<T> left, right;
};

/// `count` is not 0.
template <typename T>
ItemExtents<T> measure_items(const BuildItem<T>* items, std::size_t count);
/// Fills all three axes' bins, those that hold nothing with boxes inside out.
template <typename T>
void fill_bins(const BuildItem<T>* items, std::size_t count, const Binning<T>& binning,
               Bins<T>& bins);
/// Splits in place and keeps the order on each side, both of which get something; `scratch` has
/// room for all.
template <typename T>
Halves<T> split_by_bin(BuildItem<T>* items, std::size_t count, const Binning<T>& binning,
                       BinSplit split, BuildItem<T>* scratch);

// In float by the best instruction set there is; the same bits on each.
template <>
ItemExtents<float> measure_items(const BuildItem<float>* items, std::size_t count);
template <>
void fill_bins(const BuildItem<float>* items, std::size_t count, const Binning<float>& binning,
               Bins<float>& bins);
template <>
Halves<float> split_by_bin(BuildItem<float>* items, std::size_t count,
                           const Binning<float>& binning, BinSplit split,
                           BuildItem<float>* scratch);

template <typename T>
ItemExtents<T> measure_items(const BuildItem<T>* items, std::size_t count) {
    ItemExtents<T> extents;
    for (std::size_t i = 0; i < count; ++i) {
        extents.bounds.add(items[i].bounds);
        extents.middles.add(middle_of(items[i].bounds));
        extents.kinds |= 1U << static_cast<std::uint32_t>(items[i].kind);
    }
    return extents;
}

template <typename T>
void clear_bins(std::uint32_t count, Bins<T>& bins) {
    constexpr T kInfinity = std::numeric_limits<T>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::uint32_t b = 0; b < count; ++b) {
            bins.bins[axis][b] = {{kInfinity, kInfinity, kInfinity, kInfinity},
                                  {kInfinity, kInfinity, kInfinity, kInfinity}};
            bins.counts[axis][b] = 0;
        }
    }
}

template <typename T>
void fill_bins(const BuildItem<T>* items, std::size_t count, const Binning<T>& binning,
               Bins<T>& bins) {
    clear_bins(binning.bins, bins);
    for (std::size_t i = 0; i < count; ++i) {
        const BoxBounds<T>& box = items[i].bounds;
        const math::Vec3<T> middle = middle_of(box);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t b = binning.bin(middle, axis);
            Bin<T>& bin = bins.bins[axis][b];
            for (std::size_t a = 0; a < 3; ++a) {
                bin.lo[a] = box.lo[a] < bin.lo[a] ? box.lo[a] : bin.lo[a];
                bin.minus_hi[a] = -box.hi[a] < bin.minus_hi[a] ? -box.hi[a] : bin.minus_hi[a];
            }
            bins.counts[axis][b] += 1;
        }
    }
}

template <typename T>
Halves<T> split_by_bin(BuildItem<T>* items, std::size_t count, const Binning<T>& binning,
                       BinSplit split, BuildItem<T>* scratch) {
    // Every item is written to both sides, and counts on one: no branch to guess.
    std::size_t left = 0;
    std::size_t right = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const BuildItem<T> item = items[i];
        const bool first = binning.bin(middle_of(item.bounds), split.axis) < split.bin;
        items[left] = item;
        scratch[right] = item;
        left += first ? 1 : 0;
        right += first ? 0 : 1;
    }
    for (std::size_t i = 0; i < right; ++i) items[left + i] = scratch[i];
    return {static_cast<std::uint32_t>(left), measure_items(items, left),
            measure_items(items + left, right)};
}

}  // namespace cobble::renderer
