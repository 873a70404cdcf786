// SPDX-License-Identifier: MIT
#include "renderer/accel/builder.hpp"

#include <array>
#include <cstddef>
#include <limits>

#include "renderer/accel/half_area.hpp"

namespace cobble::renderer {

namespace {

constexpr std::uint32_t kBins = 16;
/// A leaf is tested about as fast as one step of the traversal, which costs some 4 scalar tests.
constexpr std::uint32_t kMaxLeaf = 4;

template <typename T>
struct BinaryNode {
    BoxBounds<T> bounds;
    std::uint32_t left = 0, right = 0;  ///< both 0: a leaf
    std::uint32_t first = 0, count = 0;
    [[nodiscard]] bool leaf() const { return left == 0; }
};

struct Task {
    std::uint32_t node, first, count, depth;
};

bool is_set(const std::atomic<bool>* flag) {
    return flag != nullptr && flag->load(std::memory_order_relaxed);
}

/// Calls work(i) for each i from `first` on, `count` of them, but ends early once `cancelled` is
/// true: a pass over all items of a large scene takes longer than anybody wants to wait.
template <typename Work>
void for_each_index(std::uint32_t first, std::uint32_t count, const std::atomic<bool>* cancelled,
                    Work work) {
    constexpr std::uint32_t kBetweenLooks = 1U << 14U;  // some 0.1 ms
    for (std::uint32_t done = 0; done < count && !is_set(cancelled);) {
        const std::uint32_t some = count - done < kBetweenLooks ? count - done : kBetweenLooks;
        for (std::uint32_t i = first + done; i < first + done + some; ++i) work(i);
        done += some;
    }
}

/// Twice the centre, so that nothing is rounded away by halving.
template <typename T>
double twice_center(const BoxBounds<T>& b, std::size_t axis) {
    return double{b.lo[axis]} + double{b.hi[axis]};
}

/// Items for which `left` holds first, both halves in their old order; gives how many.
template <typename T, typename Left>
std::uint32_t stable_split(std::vector<BuildItem<T>>& items, std::vector<BuildItem<T>>& scratch,
                           std::uint32_t first, std::uint32_t count,
                           const std::atomic<bool>* cancelled, Left left) {
    std::uint32_t kept = 0;
    scratch.clear();
    for_each_index(first, count, cancelled, [&](std::uint32_t i) {
        if (left(items[i])) {
            items[first + kept++] = items[i];
        } else {
            scratch.push_back(items[i]);
        }
    });
    for (std::uint32_t i = 0; i < scratch.size(); ++i) items[first + kept + i] = scratch[i];
    return kept;
}

/// The number of the item's bin. Bounded by comparison, so that no rounding leads outside.
template <typename T>
std::uint32_t bin_of(const BuildItem<T>& item, std::size_t axis, double lo, double per_unit) {
    const double at = (twice_center(item.bounds(), axis) - lo) * per_unit;
    if (!(at > 0)) return 0;
    return at < kBins ? static_cast<std::uint32_t>(at) : kBins - 1;
}

struct Split {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t axis = 0;
    std::uint32_t bin = 0;  ///< the first one on the right
    double lo = 0, per_unit = 0;
};

/// The best of all bin borders on all axes; infinite cost if all centres coincide.
template <typename T>
Split best_split(const std::vector<BuildItem<T>>& items, std::uint32_t first, std::uint32_t count,
                 const std::atomic<bool>* cancelled) {
    Split best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double lo = std::numeric_limits<double>::infinity();
        double hi = -lo;
        for_each_index(first, count, cancelled, [&](std::uint32_t i) {
            const double c = twice_center(items[i].bounds(), axis);
            lo = c < lo ? c : lo;
            hi = c > hi ? c : hi;
        });
        const double per_unit = kBins / (hi - lo);
        if (!(hi > lo) || !(per_unit <= std::numeric_limits<double>::max())) continue;
        std::array<BoxBounds<T>, kBins> bounds;
        std::array<std::uint32_t, kBins> counts{};
        for_each_index(first, count, cancelled, [&](std::uint32_t i) {
            const std::uint32_t bin = bin_of(items[i], axis, lo, per_unit);
            bounds[bin].add(items[i].bounds());
            counts[bin] += 1;
        });
        std::array<double, kBins> right_cost{};
        BoxBounds<T> sum;
        std::uint32_t n = 0;
        for (std::uint32_t bin = kBins - 1; bin > 0; --bin) {
            sum.add(bounds[bin]);
            n += counts[bin];
            right_cost[bin] = half_area(sum) * n;
        }
        sum = {};
        n = 0;
        for (std::uint32_t bin = 1; bin < kBins; ++bin) {
            sum.add(bounds[bin - 1]);
            n += counts[bin - 1];
            if (n == 0 || n == count) continue;
            const double cost = half_area(sum) * n + right_cost[bin];
            if (cost < best.cost) best = {cost, axis, bin, lo, per_unit};
        }
    }
    return best;
}

/// Not to be used if `cancelled` has become true.
template <typename T>
std::vector<BinaryNode<T>> build_binary(std::vector<BuildItem<T>>& items,
                                        const std::atomic<bool>* cancelled) {
    std::vector<BinaryNode<T>> nodes(1);
    std::vector<BuildItem<T>> scratch;
    std::vector<Task> tasks{{0, 0, static_cast<std::uint32_t>(items.size()), 0}};
    while (!tasks.empty() && !is_set(cancelled)) {
        const Task task = tasks.back();
        tasks.pop_back();
        BoxBounds<T> bounds;
        bool mixed = false;
        const PrimitiveKind kind = items[task.first].kind();
        for_each_index(task.first, task.count, cancelled, [&](std::uint32_t i) {
            bounds.add(items[i].bounds());
            mixed = mixed || items[i].kind() != kind;
        });
        nodes[task.node].bounds = bounds;
        nodes[task.node].first = task.first;
        nodes[task.node].count = task.count;

        std::uint32_t left = 0;
        const bool may_be_leaf = task.count <= kMaxLeaf;
        if (task.count > 1) {
            Split split;
            if (task.depth < kHalvingDepth) {
                split = best_split(items, task.first, task.count, cancelled);
            }
            const double area = half_area(bounds);
            // One step of the traversal costs about what one primitive does.
            if (!may_be_leaf || split.cost + area < area * task.count) {
                if (split.cost < std::numeric_limits<double>::infinity()) {
                    left = stable_split(items, scratch, task.first, task.count, cancelled,
                                        [&](const BuildItem<T>& item) {
                                            return bin_of(item, split.axis, split.lo,
                                                          split.per_unit) < split.bin;
                                        });
                } else if (!may_be_leaf) {
                    left = task.count / 2;
                }
            }
            if (left == 0 && mixed) {
                left = stable_split(items, scratch, task.first, task.count, cancelled,
                                    [&](const BuildItem<T>& item) { return item.kind() == kind; });
            }
        }
        if (left == 0) continue;
        const auto child = static_cast<std::uint32_t>(nodes.size());
        nodes[task.node].left = child;
        nodes[task.node].right = child + 1;
        nodes.resize(nodes.size() + 2);
        tasks.push_back({child + 1, task.first + left, task.count - left, task.depth + 1});
        tasks.push_back({child, task.first, left, task.depth + 1});
    }
    return nodes;
}

}  // namespace

template <typename T>
Tree<T> build_tree(std::vector<BuildItem<T>>& items, const std::atomic<bool>* cancelled) {
    Tree<T> tree;
    if (items.empty()) return tree;
    const std::vector<BinaryNode<T>> binary = build_binary(items, cancelled);
    if (is_set(cancelled)) return tree;
    tree.bounds = binary[0].bounds;

    // The place of each item among those of its kind.
    std::vector<std::uint32_t> rank(items.size());
    std::array<std::uint32_t, kPrimitiveKinds> seen{};
    for (std::size_t i = 0; i < items.size(); ++i) {
        rank[i] = seen[static_cast<std::size_t>(items[i].kind())]++;
    }

    struct Pending {
        std::uint32_t wide, binary;
    };
    std::vector<Pending> pending{{0, 0}};
    tree.nodes.resize(1);
    while (!pending.empty()) {
        if (is_set(cancelled)) return {};
        const Pending at = pending.back();
        pending.pop_back();
        std::array<std::uint32_t, Node<T>::kWidth> children{at.binary};
        std::size_t count = 1;
        // Opens the child with the largest surface until four are there.
        while (count < Node<T>::kWidth) {
            std::size_t widest = count;
            double area = -1;
            for (std::size_t i = 0; i < count; ++i) {
                const auto& child = binary[children[i]];
                if (!child.leaf() && half_area(child.bounds) > area) {
                    area = half_area(child.bounds);
                    widest = i;
                }
            }
            if (widest == count) break;
            const auto opened = children[widest];
            children[widest] = binary[opened].left;
            children[count++] = binary[opened].right;
        }
        Node<T> node;
        const BoxBounds<T> empty;
        for (std::size_t i = 0; i < Node<T>::kWidth; ++i) {
            const BoxBounds<T>& b = i < count ? binary[children[i]].bounds : empty;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                node.bounds[0][axis][i] = b.lo[axis];
                node.bounds[1][axis][i] = b.hi[axis];
            }
            node.first[i] = 0;
            node.count[i] = 0;
            node.kind[i] = PrimitiveKind::kTriangle;
            if (i >= count) continue;
            const auto& child = binary[children[i]];
            if (child.leaf()) {
                node.first[i] = rank[child.first];
                node.count[i] = static_cast<std::uint8_t>(child.count);
                node.kind[i] = items[child.first].kind();
            } else {
                node.first[i] = static_cast<std::uint32_t>(tree.nodes.size());
                pending.push_back({node.first[i], children[i]});
                tree.nodes.resize(tree.nodes.size() + 1);
            }
        }
        tree.nodes[at.wide] = node;
    }
    return tree;
}

template Tree<float> build_tree(std::vector<BuildItem<float>>&, const std::atomic<bool>*);
template Tree<double> build_tree(std::vector<BuildItem<double>>&, const std::atomic<bool>*);

}  // namespace cobble::renderer
