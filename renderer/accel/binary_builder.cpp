// SPDX-License-Identifier: MIT
#include "renderer/accel/binary_builder.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>

#include "renderer/accel/build_kernels.hpp"
#include "renderer/accel/wide_tree.hpp"

namespace cobble::renderer {

namespace {

/// Below this many items fewer bins are as good, and cost less than the items do.
constexpr std::uint32_t kFewItems = 24;
constexpr std::uint32_t kFewBins = 8;
/// From here on the items are halved whatever the heuristic says, so that no tree is deeper than
/// kMaxTreeDepth (see builder.cpp).
constexpr std::uint32_t kHalvingDepth = 40;
/// A subtree of at most this share of all items, or this many, is built by one worker.
constexpr std::uint32_t kShares = 16;
constexpr std::uint32_t kSmallSubtree = 4096;

/// How many of a kind one slot of a node can lead to.
std::uint32_t slot_capacity(PrimitiveKind kind) {
    return kind == PrimitiveKind::kTriangle || kind == PrimitiveKind::kSphere ? kBlockLanes : 1;
}

/// Slots that `n` primitives need: what a traversal pays for.
std::uint32_t slots(std::uint32_t n) { return (n + 3) / 4; }

template <typename T>
struct Task {
    std::uint32_t node, first, count, depth;
    ItemExtents<T> extents;
};

/// Grows from one end of an axis' bins to the other. Areas are in units of the node's longest
/// side, so that none overflows.
template <typename T>
class Sweep {
  public:
    explicit Sweep(T unit) : unit_(unit) {}

    void add(const Bin<T>& bin, std::uint32_t n) {
        for (std::size_t a = 0; a < 3; ++a) {
            lo_[a] = bin.lo[a] < lo_[a] ? bin.lo[a] : lo_[a];
            minus_hi_[a] = bin.minus_hi[a] < minus_hi_[a] ? bin.minus_hi[a] : minus_hi_[a];
        }
        count_ += n;
    }
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// Not before something was added.
    [[nodiscard]] T cost() const {
        const T x = (-minus_hi_[0] - lo_[0]) * unit_;
        const T y = (-minus_hi_[1] - lo_[1]) * unit_;
        const T z = (-minus_hi_[2] - lo_[2]) * unit_;
        return ((x * y + y * z) + z * x) * static_cast<T>(slots(count_));
    }

  private:
    static constexpr T kInfinity = std::numeric_limits<T>::infinity();

    T unit_;
    std::array<T, 3> lo_{kInfinity, kInfinity, kInfinity};
    std::array<T, 3> minus_hi_{kInfinity, kInfinity, kInfinity};
    std::uint32_t count_ = 0;
};

template <typename T>
struct WeighedSplit {
    T cost = std::numeric_limits<T>::infinity();
    BinSplit split;
};

template <typename T>
WeighedSplit<T> best_split(const BuildItem<T>* items, std::uint32_t count,
                           const BoxBounds<T>& bounds, const Binning<T>& binning) {
    Bins<T> bins;
    fill_bins(items, count, binning, bins);
    const math::Vec3<T> sides = bounds.hi - bounds.lo;
    const T unit = 1 / std::max({sides.x, sides.y, sides.z, std::numeric_limits<T>::min()});
    WeighedSplit<T> best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(binning.per_unit[axis] > 0)) continue;
        std::array<T, kMostBins> right_cost;
        Sweep<T> right(unit);
        for (std::uint32_t bin = binning.bins - 1; bin > 0; --bin) {
            right.add(bins.bins[axis][bin], bins.counts[axis][bin]);
            right_cost[bin] = right.count() == 0 ? T(0) : right.cost();
        }
        Sweep<T> left(unit);
        for (std::uint32_t bin = 1; bin < binning.bins; ++bin) {
            left.add(bins.bins[axis][bin - 1], bins.counts[axis][bin - 1]);
            if (left.count() == 0 || left.count() == count) continue;
            const T cost = left.cost() + right_cost[bin];
            if (cost < best.cost) best = {cost, {axis, bin}};
        }
    }
    return best;
}

template <typename T>
class BinaryBuilder {
  public:
    BinaryBuilder(std::vector<BuildItem<T>>& items, const BuildControl& control)
        : items_(items),
          scratch_bytes_(
              std::make_unique_for_overwrite<std::byte[]>(items.size() * sizeof(BuildItem<T>))),
          scratch_(reinterpret_cast<BuildItem<T>*>(scratch_bytes_.get())),
          control_(control) {}

    BinaryTree<T> run() {
        const auto all = static_cast<std::uint32_t>(items_.size());
        const std::uint32_t most = std::max(all / kShares, kSmallSubtree);
        tree_.nodes.resize(1);
        std::vector<Task<T>> big = {{0, 0, all, 0, measure_items(items_.data(), all)}};
        std::vector<Task<T>> small;
        while (!big.empty() && !control_.stopped()) {
            const Task<T> task = big.back();
            big.pop_back();
            if (task.count <= most) {
                small.push_back(task);
            } else {
                halve(tree_.nodes, task, big);
            }
        }
        // Each on its own; together they are put in the order in which they were found.
        std::vector<std::vector<BinaryNode<T>>> parts(small.size());
        control_.for_each(small.size(), [&](std::size_t i) { parts[i] = build(small[i]); });
        for (std::size_t i = 0; i < small.size(); ++i) append(parts[i], small[i].node);
        return std::move(tree_);
    }

  private:
    using Nodes = std::vector<BinaryNode<T>>;

    /// Splits one node, and notes its halves to be split.
    void halve(Nodes& nodes, const Task<T>& task, std::vector<Task<T>>& tasks) {
        nodes[task.node] = {task.extents.bounds, 0, task.first, task.count};
        const Halves<T> halves = split(task);
        const std::uint32_t left = halves.left_count;
        if (left == 0) return;
        const auto child = static_cast<std::uint32_t>(nodes.size());
        nodes[task.node].left = child;
        nodes.resize(nodes.size() + 2);
        const std::uint32_t depth = task.depth + 1;
        tasks.push_back({child + 1, task.first + left, task.count - left, depth, halves.right});
        tasks.push_back({child, task.first, left, depth, halves.left});
    }

    Nodes build(const Task<T>& root) {
        Nodes nodes(1);
        nodes.reserve(root.count);
        std::vector<Task<T>> tasks = {{0, root.first, root.count, root.depth, root.extents}};
        while (!tasks.empty() && !control_.stopped()) {
            const Task<T> task = tasks.back();
            tasks.pop_back();
            halve(nodes, task, tasks);
        }
        return nodes;
    }

    /// Puts a subtree's root in its place, and its other nodes behind all that are there.
    void append(const Nodes& nodes, std::uint32_t place) {
        const auto shift = static_cast<std::uint32_t>(tree_.nodes.size()) - 1;
        tree_.subtrees.push_back(shift + 1);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            BinaryNode<T> node = nodes[i];
            if (!node.leaf()) node.left += shift;
            if (i == 0) {
                tree_.nodes[place] = node;
            } else {
                tree_.nodes.push_back(node);
            }
        }
    }

    /// Nothing on the left for a leaf.
    Halves<T> split(const Task<T>& task) {
        if (task.count == 1) return {};
        BuildItem<T>* const items = items_.data() + task.first;
        const PrimitiveKind kind = items[0].kind;
        const bool mixed = task.extents.kinds != 1U << static_cast<std::uint32_t>(kind);
        if (!mixed && task.count <= slot_capacity(kind)) return {};
        if (task.depth < kHalvingDepth) {
            const Binning<T> binning(task.extents.middles,
                                     task.count < kFewItems ? kFewBins : kMostBins);
            const auto best = best_split(items, task.count, task.extents.bounds, binning);
            if (best.cost < std::numeric_limits<T>::infinity()) {
                return split_by_bin(items, task.count, binning, best.split, scratch_ + task.first);
            }
        }
        std::uint32_t left = task.count / 2;
        if (mixed && task.count <= 2 * kBlockLanes) {
            const auto* const end =
                std::stable_partition(items, items + task.count,
                                      [&](const BuildItem<T>& item) { return item.kind == kind; });
            left = static_cast<std::uint32_t>(end - items);
        }
        return {left, measure_items(items, left), measure_items(items + left, task.count - left)};
    }

    std::vector<BuildItem<T>>& items_;
    /// As many items as items_ has, none of them written before it is needed.
    std::unique_ptr<std::byte[]> scratch_bytes_;
    BuildItem<T>* scratch_;
    const BuildControl& control_;
    BinaryTree<T> tree_;
};

}  // namespace

template <typename T>
BinaryTree<T> build_binary_tree(std::vector<BuildItem<T>>& items, const BuildControl& control) {
    return BinaryBuilder<T>(items, control).run();
}

template BinaryTree<float> build_binary_tree(std::vector<BuildItem<float>>&, const BuildControl&);
template BinaryTree<double> build_binary_tree(std::vector<BuildItem<double>>&, const BuildControl&);

}  // namespace cobble::renderer
