// SPDX-License-Identifier: MIT
#include "renderer/accel/coarse_split.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <memory>

namespace cobble::renderer {

namespace {

/// Fewer places to split at than this, and a finer grid is worth its passes.
constexpr std::uint32_t kLeastWidth = 8;

/// A cell that holds something.
template <typename T>
struct Filled {
    ItemExtents<T> extents;
    std::uint32_t items;
    std::uint32_t cell;
    [[nodiscard]] std::uint32_t at(std::size_t axis) const {
        return cell >> (axis * kCellBits) & (kCellsAlong - 1);
    }
};

template <typename T>
class CoarseSplit {
  public:
    CoarseSplit(const ItemExtents<T>& extents, std::uint32_t count, std::uint32_t levels)
        : levels_(levels), unit_(area_unit(extents.box)) {
        nodes_.push_back({extents, 0, count, 0, 0});
    }

    std::vector<CoarseNode<T>> run(const BuildItem<T>* items, BuildItem<T>* to) {
        const std::uint32_t count = nodes_[0].count;
        const auto cell_of = std::make_unique_for_overwrite<std::uint16_t[]>(count);
        gather(items, cell_of.get());
        std::vector<Set> sets = {{0, 0, static_cast<std::uint32_t>(filled_.size())}};
        while (!sets.empty()) {
            const Set set = sets.back();
            sets.pop_back();
            if (!split(set, sets)) finish(set);
        }
        if (nodes_.size() > 1) move(items, count, cell_of.get(), to);
        return std::move(nodes_);
    }

  private:
    /// Cells [begin, end) of filled_.
    struct Set {
        std::uint32_t node, begin, end;
    };

    void gather(const BuildItem<T>* items, std::uint16_t* cell_of) {
        const auto extents = std::make_unique_for_overwrite<ItemExtents<T>[]>(kCells);
        std::vector<std::uint32_t> counts(kCells);
        sort_into_cells(items, nodes_[0].count, nodes_[0].extents.middles,
                        {extents.get(), counts.data(), cell_of});
        for (std::uint32_t cell = 0; cell < kCells; ++cell) {
            if (counts[cell] > 0) filled_.push_back({extents[cell], counts[cell], cell});
        }
    }

    /// False if a node is not to be split any more.
    bool split(const Set& set, std::vector<Set>& sets) {
        const CoarseNode<T> node = nodes_[set.node];
        if (node.depth >= levels_ || node.count <= kCoarseItems) return false;
        std::array<std::uint32_t, 3> least{kCellsAlong, kCellsAlong, kCellsAlong};
        std::array<std::uint32_t, 3> most{};
        for (std::uint32_t i = set.begin; i < set.end; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                least[axis] = std::min(least[axis], filled_[i].at(axis));
                most[axis] = std::max(most[axis], filled_[i].at(axis));
            }
        }
        std::array<std::uint32_t, 3> shift{};
        std::uint32_t widest = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t width = most[axis] - least[axis] + 1;
            shift[axis] = width > kMostBins ? 1 : 0;
            widest = std::max(widest, width);
        }
        if (widest < kLeastWidth) return false;
        const auto bin = [&](const Filled<T>& cell, std::size_t axis) {
            return (cell.at(axis) - least[axis]) >> shift[axis];
        };
        Bins<T> bins;
        plain::clear_bins(kMostBins, bins);
        for (std::uint32_t i = set.begin; i < set.end; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::uint32_t b = bin(filled_[i], axis);
                bins.extents[b][axis].add(filled_[i].extents.box);
                bins.counts[b][axis] += filled_[i].items;
            }
        }
        const BinSplit where = plain::best_split(bins, kMostBins, unit_);
        if (where.bin == 0) return false;
        const auto begin = filled_.begin();
        const auto middle = std::stable_partition(
            begin + set.begin, begin + set.end,
            [&](const Filled<T>& cell) { return bin(cell, where.axis) < where.bin; });
        const auto at = static_cast<std::uint32_t>(middle - begin);
        const auto left = static_cast<std::uint32_t>(nodes_.size());
        nodes_[set.node].left = left;
        nodes_.push_back(together(set.begin, at, node.first, node.depth + 1));
        nodes_.push_back(together(at, set.end, node.first + nodes_[left].count, node.depth + 1));
        sets.push_back({left + 1, at, set.end});
        sets.push_back({left, set.begin, at});
        return true;
    }

    CoarseNode<T> together(std::uint32_t begin, std::uint32_t end, std::uint32_t first,
                           std::uint32_t depth) const {
        CoarseNode<T> node{{}, first, 0, depth, 0};
        for (std::uint32_t i = begin; i < end; ++i) {
            node.extents.box.add(filled_[i].extents.box);
            node.extents.middles.add(filled_[i].extents.middles);
            node.count += filled_[i].items;
        }
        return node;
    }

    void finish(const Set& set) {
        const auto number = static_cast<std::uint32_t>(ends_.size());
        ends_.push_back(nodes_[set.node].first);
        for (std::uint32_t i = set.begin; i < set.end; ++i) end_of_[filled_[i].cell] = number;
    }

    void move(const BuildItem<T>* items, std::uint32_t count, const std::uint16_t* cell_of,
              BuildItem<T>* to) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t place = ends_[end_of_[cell_of[i]]]++;
            std::memcpy(&to[place], &items[i], sizeof(BuildItem<T>));
        }
    }

    std::uint32_t levels_;
    T unit_;
    std::vector<CoarseNode<T>> nodes_;
    std::vector<Filled<T>> filled_;
    std::vector<std::uint32_t> ends_;  ///< where the next item of each last node goes
    std::vector<std::uint32_t> end_of_ = std::vector<std::uint32_t>(kCells);
};

}  // namespace

template <typename T>
std::vector<CoarseNode<T>> split_coarsely(const BuildItem<T>* items, std::uint32_t count,
                                          const ItemExtents<T>& extents, std::uint32_t levels,
                                          BuildItem<T>* to) {
    return CoarseSplit<T>(extents, count, levels).run(items, to);
}

template std::vector<CoarseNode<float>> split_coarsely(const BuildItem<float>*, std::uint32_t,
                                                       const ItemExtents<float>&, std::uint32_t,
                                                       BuildItem<float>*);
template std::vector<CoarseNode<double>> split_coarsely(const BuildItem<double>*, std::uint32_t,
                                                        const ItemExtents<double>&, std::uint32_t,
                                                        BuildItem<double>*);

}  // namespace cobble::renderer
