// SPDX-License-Identifier: MIT
#include "renderer/accel/binary_builder.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>

#include "renderer/accel/build_kernels.hpp"
#include "renderer/accel/coarse_split.hpp"
#include "renderer/accel/wide_tree.hpp"

namespace cobble::renderer {

namespace {

/// Below this many items fewer bins are as good, and cost less than the items do.
constexpr std::uint32_t kFewItems = 24;
constexpr std::uint32_t kFewBins = 8;
/// A subtree of at most this share of all items, or this many, is built by one worker.
constexpr std::uint32_t kShares = 16;
constexpr std::uint32_t kSmallSubtree = 4096;

/// How many of a kind one slot of a node can lead to.
std::uint32_t slot_capacity(PrimitiveKind kind) {
    if (kind == PrimitiveKind::kTriangle) return kBlockLanes;
    return kind == PrimitiveKind::kSphere ? kSphereLanes : 1;
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
        std::vector<BinaryNode<T>> top(1);
        std::vector<Task<T>> big = {
            {0, 0, all_, 0, false, mixed_kinds(items_, all_), measure_items(items_, all_)}};
        std::vector<Task<T>> small;
        while (!big.empty() && !control_.stopped()) {
            const Task<T> task = big.back();
            big.pop_back();
            if (task.count <= most) {
                small.push_back(task);
                continue;
            }
            const auto child = static_cast<std::uint32_t>(top.size());
            const auto make = [&top](std::size_t more) {
                top.resize(top.size() + more);
                return top.data();
            };
            split_further(make, task, child, big);
        }
        BinaryTree<T> tree;
        tree.top = static_cast<std::uint32_t>(top.size());
        // A subtree of n items has at most 2 n - 1 nodes. Most have less than a third of that, and
        // what nobody writes costs nothing.
        tree.all = tree.top + 2 * all_;
        tree.nodes = std::make_unique_for_overwrite<BinaryNode<T>[]>(tree.all);
        std::copy(top.begin(), top.end(), tree.nodes.get());
        tree.subtrees.resize(small.size());
        control_.for_each(small.size(), [&](std::size_t i) {
            const std::uint32_t begin = tree.top + 2 * small[i].first;
            tree.subtrees[i] = {begin, build(tree.nodes.get(), small[i], begin)};
        });
        for (const auto& range : tree.subtrees) tree.leaves += (range.end - range.begin) / 2 + 1;
        return tree;
    }

  private:
    /// Builds what is below a node that has its place, from `end` on. Gives the new end.
    std::uint32_t build(BinaryNode<T>* nodes, const Task<T>& root, std::uint32_t end) {
        std::vector<Task<T>> tasks = {root};
        while (!tasks.empty() && !control_.stopped()) {
            const Task<T> task = tasks.back();
            tasks.pop_back();
            const auto make = [&](std::size_t more) {
                end += static_cast<std::uint32_t>(more);
                return nodes;
            };
            split_further(make, task, end, tasks);
        }
        return end;
    }

    /// Splits a node, and notes what it was split into, whose nodes are from `child` on. make(n)
    /// gives all nodes, with room for n more; called once, unless it is a leaf.
    template <typename Make>
    void split_further(const Make& make, const Task<T>& task, std::uint32_t child,
                       std::vector<Task<T>>& tasks) {
        BuildItem<T>* const items = place(task);
        if (task.count == 1 || (!task.mixed && task.count <= slot_capacity(items[0].kind()))) {
            set(make(0)[task.node], task.extents, task.first, task.count);
            if (task.elsewhere) std::copy_n(items, task.count, items_ + task.first);
            return;
        }
        if (task.count >= kManyItems && task.depth < kHalvingDepth) {
            const auto levels =
                split_coarsely(items, task.count, task.extents, kHalvingDepth - task.depth,
                               place(task, !task.elsewhere));
            if (levels.size() > 1) {
                note(make(levels.size() - 1), task, child, levels, tasks);
                return;
            }
        }
        bool elsewhere = task.elsewhere;
        const Halves<T> halves = split(items, task, elsewhere);
        set(make(2)[task.node], task.extents, child, 0);
        const std::uint32_t left = halves.left_count;
        const std::uint32_t depth = task.depth + 1;
        note({child + 1, task.first + left, task.count - left, depth, elsewhere, task.mixed,
              halves.right},
             tasks);
        note({child, task.first, left, depth, elsewhere, task.mixed, halves.left}, tasks);
    }

    void note(BinaryNode<T>* nodes, const Task<T>& task, std::uint32_t child,
              const std::vector<CoarseNode<T>>& levels, std::vector<Task<T>>& tasks) {
        // The first one is taken last from the end.
        for (std::size_t i = levels.size(); i > 0; --i) {
            const CoarseNode<T>& level = levels[i - 1];
            const std::uint32_t node =
                i == 1 ? task.node : child + static_cast<std::uint32_t>(i) - 2;
            if (level.left > 0) {
                set(nodes[node], level.extents, child + level.left - 1, 0);
            } else {
                note({node, task.first + level.first, level.count, task.depth + level.depth,
                      !task.elsewhere, task.mixed, level.extents},
                     tasks);
            }
        }
    }

    /// Of a part of what was mixed it is not yet known whether it is.
    void note(const Task<T>& task, std::vector<Task<T>>& tasks) {
        tasks.push_back(task);
        tasks.back().mixed = task.mixed && mixed_kinds(place(task), task.count);
    }

    static void set(BinaryNode<T>& node, const ItemExtents<T>& extents, std::uint32_t at,
                    std::uint32_t count) {
        for (std::size_t a = 0; a < 3; ++a) {
            node.lo[a] = extents.box.lo[a];
            node.hi[a] = -extents.box.minus_hi[a];
        }
        node.at = at;
        node.count = count;
    }

    [[nodiscard]] BuildItem<T>* place(const Task<T>& task) const {
        return place(task, task.elsewhere);
    }
    [[nodiscard]] BuildItem<T>* place(const Task<T>& task, bool elsewhere) const {
        return (elsewhere ? others_.get() : items_) + task.first;
    }

    /// Changes `elsewhere` if the halves are not where the whole was.
    Halves<T> split(BuildItem<T>* items, const Task<T>& task, bool& elsewhere) {
        if (task.depth < kHalvingDepth) {
            const Halves<T> halves =
                split_items(items, task.count, task.extents,
                            task.count < kFewItems ? kFewBins : kMostBins, place(task, !elsewhere));
            if (halves.left_count > 0) {
                elsewhere = !elsewhere;
                return halves;
            }
        }
        std::uint32_t left = task.count / 2;
        if (task.mixed && task.count <= 2 * kSphereLanes) {
            const PrimitiveKind kind = items[0].kind();
            const auto* const end = std::stable_partition(
                items, items + task.count,
                [&](const BuildItem<T>& item) { return item.kind() == kind; });
            left = static_cast<std::uint32_t>(end - items);
        }
        return {left, measure_items(items, left), measure_items(items + left, task.count - left)};
    }

    BuildItem<T>* items_;
    std::uint32_t all_;
    /// As many as all: a split moves items from one array to the other, and leaves move them home.
    std::unique_ptr<BuildItem<T>[]> others_;
    const BuildControl& control_;
};

}  // namespace

template <typename T>
BinaryTree<T> build_binary_tree(std::vector<BuildItem<T>>& items, const BuildControl& control) {
    return BinaryBuilder<T>(items, control).run();
}

template BinaryTree<float> build_binary_tree(std::vector<BuildItem<float>>&, const BuildControl&);
template BinaryTree<double> build_binary_tree(std::vector<BuildItem<double>>&, const BuildControl&);

}  // namespace cobble::renderer
