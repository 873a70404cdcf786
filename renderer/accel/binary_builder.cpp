// SPDX-License-Identifier: MIT
#include "renderer/accel/binary_builder.hpp"

#include <algorithm>
#include <cstddef>
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

/// Some items that lie together, in the caller's array or in the other one.
template <typename T>
struct Task {
    std::uint32_t node, first, count, depth;
    bool elsewhere, mixed;
    ItemExtents<T> extents;
};

template <typename T>
bool mixed_kinds(const BuildItem<T>* items, std::uint32_t count) {
    return std::any_of(items, items + count, [items](const BuildItem<T>& item) {
        return item.kind() != items[0].kind();
    });
}

template <typename T>
class BinaryBuilder {
  public:
    BinaryBuilder(std::vector<BuildItem<T>>& items, const BuildControl& control)
        : items_(items.data()),
          all_(static_cast<std::uint32_t>(items.size())),
          others_(std::make_unique_for_overwrite<BuildItem<T>[]>(items.size())),
          control_(control) {}

    BinaryTree<T> run() {
        const std::uint32_t most = std::max(all_ / kShares, kSmallSubtree);
        tree_.nodes.resize(1);
        std::vector<Task<T>> big = {
            {0, 0, all_, 0, false, mixed_kinds(items_, all_), measure_items(items_, all_)}};
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
        nodes[task.node] = {task.extents.box.box(), 0, task.first, task.count};
        BuildItem<T>* const items = place(task);
        const PrimitiveKind kind = items[0].kind();
        if (task.count == 1 || (!task.mixed && task.count <= slot_capacity(kind))) {
            if (task.elsewhere) std::copy_n(items, task.count, items_ + task.first);
            return;
        }
        bool elsewhere = task.elsewhere;
        const Halves<T> halves = split(items, task, elsewhere);
        const std::uint32_t left = halves.left_count;
        const auto child = static_cast<std::uint32_t>(nodes.size());
        nodes[task.node].left = child;
        nodes.resize(nodes.size() + 2);
        const auto note = [&](std::uint32_t node, std::uint32_t first, std::uint32_t count,
                              const ItemExtents<T>& extents) {
            Task<T> half{node, first, count, task.depth + 1, elsewhere, false, extents};
            half.mixed = task.mixed && mixed_kinds(place(half), count);
            tasks.push_back(half);
        };
        note(child + 1, task.first + left, task.count - left, halves.right);
        note(child, task.first, left, halves.left);
    }

    [[nodiscard]] BuildItem<T>* place(const Task<T>& task) const {
        return (task.elsewhere ? others_.get() : items_) + task.first;
    }

    /// Changes `elsewhere` if the halves are not where the whole was.
    Halves<T> split(BuildItem<T>* items, const Task<T>& task, bool& elsewhere) {
        if (task.depth < kHalvingDepth) {
            BuildItem<T>* const to = (elsewhere ? items_ : others_.get()) + task.first;
            const Halves<T> halves = split_items(items, task.count, task.extents,
                                                 task.count < kFewItems ? kFewBins : kMostBins, to);
            if (halves.left_count > 0) {
                elsewhere = !elsewhere;
                return halves;
            }
        }
        std::uint32_t left = task.count / 2;
        if (task.mixed && task.count <= 2 * kBlockLanes) {
            const PrimitiveKind kind = items[0].kind();
            const auto* const end = std::stable_partition(
                items, items + task.count,
                [&](const BuildItem<T>& item) { return item.kind() == kind; });
            left = static_cast<std::uint32_t>(end - items);
        }
        return {left, measure_items(items, left), measure_items(items + left, task.count - left)};
    }

    Nodes build(const Task<T>& root) {
        Nodes nodes(1);
        nodes.reserve(root.count);
        std::vector<Task<T>> tasks = {root};
        tasks[0].node = 0;
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

    BuildItem<T>* items_;
    std::uint32_t all_;
    /// As many as all: a split moves items from one array to the other, and leaves move them home.
    std::unique_ptr<BuildItem<T>[]> others_;
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
