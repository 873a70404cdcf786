// SPDX-License-Identifier: MIT
// The loops over items that building a tree spends its time in.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/accel/build_item.hpp"

namespace cobble::renderer {

/// What some items span, and twice their middles.
template <typename T>
struct ItemExtents {
    Extent<T> box = Extent<T>::none();
    Extent<T> middles = Extent<T>::none();

    void add(const Extent<T>& item) {
        box.add(item);
        middles.add(middle_twice(item));
    }
    static Extent<T> middle_twice(const Extent<T>& of) {
        Extent<T> twice;
        for (std::size_t a = 0; a < 4; ++a) {
            twice.lo[a] = of.lo[a] - of.minus_hi[a];
            twice.minus_hi[a] = of.minus_hi[a] - of.lo[a];
        }
        return twice;
    }
};

inline constexpr std::uint32_t kMostBins = 16;

/// Maps twice a middle to bins; the same bin for the same middle wherever it is asked. A place is a
/// number in [1, 2): a bin is its first four bits behind the point.
template <typename T>
struct Binning {
    T lo[4], per_unit[4];  ///< per_unit is 0 along an axis that can not be binned; [3] is 0
    T last;                ///< the middle of the last bin
    std::uint32_t bins;

    /// `count`: at most kMostBins.
    Binning(const Extent<T>& middles, std::uint32_t count)
        : lo{}, per_unit{}, last((static_cast<T>(count) - T(0.5)) / kMostBins + 1), bins(count) {
        const T share = static_cast<T>(bins) / kMostBins;
        for (std::size_t a = 0; a < 3; ++a) {
            const T scale = share / (-middles.minus_hi[a] - middles.lo[a]);
            lo[a] = middles.lo[a];
            per_unit[a] = scale <= std::numeric_limits<T>::max() ? scale : T(0);
        }
    }
    [[nodiscard]] T place(const Extent<T>& item, std::size_t axis) const {
        return ((item.lo[axis] - item.minus_hi[axis]) - lo[axis]) * per_unit[axis] + 1;
    }
    /// Bins below `bin` are of places below this.
    [[nodiscard]] static T begin(std::uint32_t bin) { return static_cast<T>(bin) / kMostBins + 1; }
    [[nodiscard]] std::uint32_t bin(const Extent<T>& item, std::size_t axis) const {
        return part_of(item, axis, kMostBins);
    }
    /// The same in `parts` of [1, 2), a power of two of at least kMostBins, if it is all of it that
    /// is binned.
    [[nodiscard]] std::uint32_t part_of(const Extent<T>& item, std::size_t axis,
                                        std::uint32_t parts) const {
        const T at = place(item, axis);
        return static_cast<std::uint32_t>(((at < last ? at : last) - 1) * static_cast<T>(parts));
    }
};
static_assert(kMostBins == 16);

/// Items by where their middles lie: for each bin along x, y and z what they span and how many they
/// are. The fourth is not used.
template <typename T>
struct Bins {
    Extent<T> extents[kMostBins][4];
    std::uint32_t counts[kMostBins][4];
};

/// The items whose bin along `axis` is below `bin` go to the left.
struct BinSplit {
    std::size_t axis = 0;
    std::uint32_t bin = 0;  ///< 0: there is no split
};

/// What a range was split into.
template <typename T>
struct Halves {
    std::uint32_t left_count = 0;
    ItemExtents<T> left, right;
};

/// Slots of wide nodes that `n` primitives need: what a traversal pays for.
inline std::uint32_t slots(std::uint32_t n) { return (n + 3) / 4; }

/// Areas are in units of a node's longest side, so that none overflows.
template <typename T>
T area_unit(const Extent<T>& box) {
    return 1 / std::max({-box.minus_hi[0] - box.lo[0], -box.minus_hi[1] - box.lo[1],
                         -box.minus_hi[2] - box.lo[2], std::numeric_limits<T>::min()});
}

/// `count` is not 0.
template <typename T>
ItemExtents<T> measure_items(const BuildItem<T>* items, std::size_t count) {
    ItemExtents<T> extents;
    for (std::size_t i = 0; i < count; ++i) extents.add(items[i].extent());
    return extents;
}

/// Splits by the surface-area heuristic over bins along each axis, of which there are `bins`: at
/// most kMostBins. The items, of which `extents` are, go `to` a place elsewhere: those on the left
/// to its begin, in their order, the others to its end, in reverse. Both sides get something, or
/// left_count is 0 and none was moved.
template <typename T>
Halves<T> split_items(const BuildItem<T>* items, std::uint32_t count, const ItemExtents<T>& extents,
                      std::uint32_t bins, BuildItem<T>* to);

/// A grid over the middles of items: so many cells along each axis, numbered by x, then y, then z.
inline constexpr std::uint32_t kCellBits = 5;
inline constexpr std::uint32_t kCellsAlong = 1U << kCellBits;
inline constexpr std::uint32_t kCells = 1U << (3 * kCellBits);

template <typename T>
struct Cells {
    ItemExtents<T>* extents;  ///< kCells; none is set of a cell without items
    std::uint32_t* counts;    ///< kCells, 0 at first
    std::uint16_t* cell_of;   ///< each item's
};

template <typename T>
void sort_into_cells(const BuildItem<T>* items, std::uint32_t count, const Extent<T>& middles,
                     const Cells<T>& cells);

// In float by the best instruction set there is; the same bits on each.
template <>
ItemExtents<float> measure_items(const BuildItem<float>* items, std::size_t count);
template <>
Halves<float> split_items(const BuildItem<float>* items, std::uint32_t count,
                          const ItemExtents<float>& extents, std::uint32_t bins,
                          BuildItem<float>* to);

template <>
void sort_into_cells(const BuildItem<float>* items, std::uint32_t count,
                     const Extent<float>& middles, const Cells<float>& cells);

/// One number after the other: for double, and where there is nothing better.
namespace plain {

template <typename T>
void clear_bins(std::uint32_t count, Bins<T>& bins) {
    for (std::uint32_t b = 0; b < count; ++b) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            bins.extents[b][axis] = Extent<T>::none();
            bins.counts[b][axis] = 0;
        }
    }
}

template <typename T>
void put(const BuildItem<T>& item, const Binning<T>& binning, Bins<T>& bins) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t b = binning.bin(item.extent(), axis);
        bins.extents[b][axis].add(item.extent());
        bins.counts[b][axis] += 1;
    }
}

template <typename T>
void sort_into_cells(const BuildItem<T>* items, std::uint32_t count, const Binning<T>& binning,
                     const Cells<T>& cells) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const Extent<T>& item = items[i].extent();
        std::uint32_t cell = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            cell |= binning.part_of(item, axis, kCellsAlong) << (axis * kCellBits);
        }
        cells.cell_of[i] = static_cast<std::uint16_t>(cell);
        if (cells.counts[cell] == 0) cells.extents[cell] = {};
        cells.counts[cell] += 1;
        cells.extents[cell].add(item);
    }
}

/// Half the surface times the slots.
template <typename T>
T cost(const Extent<T>& box, T unit, std::uint32_t count) {
    // Sides with the wrong sign, which their products lose.
    const T x = (box.lo[0] + box.minus_hi[0]) * unit;
    const T y = (box.lo[1] + box.minus_hi[1]) * unit;
    const T z = (box.lo[2] + box.minus_hi[2]) * unit;
    return ((x * y + y * z) + z * x) * static_cast<T>(slots(count));
}

/// A side without items costs NaN, infinity times 0, and is never the best.
template <typename T>
BinSplit best_split(const Bins<T>& bins, std::uint32_t count, T unit) {
    T best_cost = std::numeric_limits<T>::infinity();
    BinSplit best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::array<T, kMostBins> right_cost;
        Extent<T> side = Extent<T>::none();
        std::uint32_t items = 0;
        for (std::uint32_t bin = count - 1; bin > 0; --bin) {
            side.add(bins.extents[bin][axis]);
            items += bins.counts[bin][axis];
            right_cost[bin] = cost(side, unit, items);
        }
        side = Extent<T>::none();
        items = 0;
        for (std::uint32_t bin = 1; bin < count; ++bin) {
            side.add(bins.extents[bin - 1][axis]);
            items += bins.counts[bin - 1][axis];
            const T sum = cost(side, unit, items) + right_cost[bin];
            if (sum < best_cost) {
                best_cost = sum;
                best = {axis, bin};
            }
        }
    }
    return best;
}

/// Moves the items, and measures their middles.
template <typename T>
void part(const BuildItem<T>* items, std::uint32_t count, const Binning<T>& binning, BinSplit split,
          BuildItem<T>* to, Halves<T>& halves) {
    // Every item is written to both sides, and counts on one: no branch to guess.
    std::uint32_t left = 0;
    std::uint32_t end = count;
    for (std::uint32_t i = 0; i < count; ++i) {
        const BuildItem<T> item = items[i];
        const bool first = binning.place(item.extent(), split.axis) < Binning<T>::begin(split.bin);
        to[left] = item;
        to[end - 1] = item;
        left += first ? 1 : 0;
        end -= first ? 0 : 1;
        const Extent<T> twice = ItemExtents<T>::middle_twice(item.extent());
        (first ? halves.left : halves.right).middles.add(twice);
    }
    halves.left_count = left;
}

}  // namespace plain

template <typename T>
void sort_into_cells(const BuildItem<T>* items, std::uint32_t count, const Extent<T>& middles,
                     const Cells<T>& cells) {
    plain::sort_into_cells(items, count, Binning<T>(middles, kMostBins), cells);
}

template <typename T>
Halves<T> split_items(const BuildItem<T>* items, std::uint32_t count, const ItemExtents<T>& extents,
                      std::uint32_t bin_count, BuildItem<T>* to) {
    const Binning<T> binning(extents.middles, bin_count);
    Bins<T> bins;
    plain::clear_bins(bin_count, bins);
    for (std::uint32_t i = 0; i < count; ++i) plain::put(items[i], binning, bins);
    const BinSplit split = plain::best_split(bins, bin_count, area_unit(extents.box));
    Halves<T> halves;
    if (split.bin == 0) return halves;
    for (std::uint32_t b = 0; b < bin_count; ++b) {
        (b < split.bin ? halves.left : halves.right).box.add(bins.extents[b][split.axis]);
    }
    plain::part(items, count, binning, split, to, halves);
    return halves;
}

}  // namespace cobble::renderer
