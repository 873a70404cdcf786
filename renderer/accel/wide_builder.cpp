// SPDX-License-Identifier: MIT
#include "renderer/accel/wide_builder.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "renderer/accel/half_area.hpp"

namespace cobble::renderer {

namespace {

constexpr std::uint32_t kBins = 16;
/// From here on the items are halved whatever the heuristic says, so that no tree is deeper than
/// kMaxTreeDepth (see builder.cpp).
constexpr std::uint32_t kHalvingDepth = 40;

bool is_set(const std::atomic<bool>* flag) {
    return flag != nullptr && flag->load(std::memory_order_relaxed);
}

/// How many of a kind one slot of a node can lead to.
std::uint32_t slot_capacity(PrimitiveKind kind) {
    return kind == PrimitiveKind::kTriangle || kind == PrimitiveKind::kSphere ? kBlockLanes : 1;
}

template <typename T>
struct BinaryNode {
    BoxBounds<T> bounds;
    std::uint32_t left = 0;  ///< the right one follows it; 0: a leaf
    std::uint32_t first = 0, count = 0;
    [[nodiscard]] bool leaf() const { return left == 0; }
};

struct Task {
    std::uint32_t node, first, count, depth;
};

template <typename T>
math::Vec3<T> middle(const BoxBounds<T>& b) {
    return b.lo * T(0.5) + b.hi * T(0.5);
}

/// Maps middles to bins; the same value for the same middle wherever it is asked.
template <typename T>
struct Binning {
    math::Vec3<T> lo, per_unit;

    explicit Binning(const BoxBounds<T>& middles) : lo(middles.lo) {
        for (std::size_t a = 0; a < 3; ++a) {
            const T scale = T(kBins) / (middles.hi[a] - middles.lo[a]);
            per_unit[a] = scale <= std::numeric_limits<T>::max() ? scale : T(0);
        }
    }
    [[nodiscard]] std::uint32_t bin(math::Vec3<T> m, std::size_t axis) const {
        const T at = (m[axis] - lo[axis]) * per_unit[axis];
        return at < T(kBins) ? static_cast<std::uint32_t>(at) : kBins - 1;
    }
};

struct Split {
    double cost = std::numeric_limits<double>::infinity();
    std::size_t axis = 0;
    std::uint32_t bin = 0;  ///< the first one on the right
};

/// Slots that `n` primitives need: what a traversal pays for.
std::uint32_t slots(std::uint32_t n) { return (n + 3) / 4; }

template <typename T>
Split best_split(const std::vector<BuildItem<T>>& items, const Task& task,
                 const Binning<T>& binning) {
    std::array<std::array<BoxBounds<T>, kBins>, 3> bounds;
    std::array<std::array<std::uint32_t, kBins>, 3> counts{};
    for (std::uint32_t i = task.first; i < task.first + task.count; ++i) {
        const math::Vec3<T> m = middle(items[i].bounds);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::uint32_t bin = binning.bin(m, axis);
            bounds[axis][bin].add(items[i].bounds);
            counts[axis][bin] += 1;
        }
    }
    Split best;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(binning.per_unit[axis] > 0)) continue;
        std::array<double, kBins> right_cost{};
        BoxBounds<T> sum;
        std::uint32_t n = 0;
        for (std::uint32_t bin = kBins - 1; bin > 0; --bin) {
            sum.add(bounds[axis][bin]);
            n += counts[axis][bin];
            right_cost[bin] = half_area(sum) * slots(n);
        }
        sum = {};
        n = 0;
        for (std::uint32_t bin = 1; bin < kBins; ++bin) {
            sum.add(bounds[axis][bin - 1]);
            n += counts[axis][bin - 1];
            if (n == 0 || n == task.count) continue;
            const double cost = half_area(sum) * slots(n) + right_cost[bin];
            if (cost < best.cost) best = {cost, axis, bin};
        }
    }
    return best;
}

/// Items for which `left` holds first; gives how many. Not stable, but the same everywhere.
template <typename T, typename Left>
std::uint32_t split_items(std::vector<BuildItem<T>>& items, const Task& task, Left left) {
    std::uint32_t i = task.first;
    std::uint32_t end = task.first + task.count;
    while (i < end) {
        if (left(items[i])) {
            ++i;
        } else {
            std::swap(items[i], items[--end]);
        }
    }
    return i - task.first;
}

template <typename T>
class BinaryBuilder {
  public:
    BinaryBuilder(std::vector<BuildItem<T>>& items, const std::atomic<bool>* cancelled)
        : items_(items), cancelled_(cancelled) {}

    /// Not to be used if `cancelled` has become true.
    std::vector<BinaryNode<T>> run() {
        nodes_.reserve(items_.size());
        nodes_.resize(1);
        tasks_ = {{0, 0, static_cast<std::uint32_t>(items_.size()), 0}};
        while (!tasks_.empty() && !is_set(cancelled_)) {
            const Task task = tasks_.back();
            tasks_.pop_back();
            const std::uint32_t left = split(task);
            if (left == 0) continue;
            const auto child = static_cast<std::uint32_t>(nodes_.size());
            nodes_[task.node].left = child;
            nodes_.resize(nodes_.size() + 2);
            tasks_.push_back({child + 1, task.first + left, task.count - left, task.depth + 1});
            tasks_.push_back({child, task.first, left, task.depth + 1});
        }
        return std::move(nodes_);
    }

  private:
    /// Fills the task's node; how many items go left, 0 for a leaf.
    std::uint32_t split(const Task& task) {
        BoxBounds<T> bounds;
        BoxBounds<T> middles;
        bool mixed = false;
        const PrimitiveKind kind = items_[task.first].kind;
        for (std::uint32_t i = task.first; i < task.first + task.count; ++i) {
            bounds.add(items_[i].bounds);
            middles.add(middle(items_[i].bounds));
            mixed = mixed || items_[i].kind != kind;
        }
        nodes_[task.node].bounds = bounds;
        nodes_[task.node].first = task.first;
        nodes_[task.node].count = task.count;
        if (task.count == 1) return 0;

        const bool may_be_leaf = !mixed && task.count <= slot_capacity(kind);
        if (may_be_leaf) return 0;
        if (task.depth < kHalvingDepth) {
            const Binning<T> binning(middles);
            const Split best = best_split(items_, task, binning);
            if (best.cost < std::numeric_limits<double>::infinity()) {
                return split_items(items_, task, [&](const BuildItem<T>& item) {
                    return binning.bin(middle(item.bounds), best.axis) < best.bin;
                });
            }
        }
        if (mixed && task.count <= 2 * kBlockLanes) {
            return split_items(items_, task,
                               [&](const BuildItem<T>& item) { return item.kind == kind; });
        }
        return task.count / 2;
    }

    std::vector<BuildItem<T>>& items_;
    const std::atomic<bool>* cancelled_;
    std::vector<BinaryNode<T>> nodes_;
    std::vector<Task> tasks_;
};

/// Which binary nodes become the slots of which wide node: the cheapest of all ways, by dynamic
/// programming from the leaves up (Ylitie, Karras and Laine, Efficient Incoherent Ray Traversal on
/// GPUs Through Compressed Wide BVHs, 2017, section 4).
template <typename T>
class Collapse {
  public:
    Collapse(const std::vector<BinaryNode<T>>& binary, const std::vector<BuildItem<T>>& items)
        : binary_(binary), items_(items), plans_(binary.size()) {}

    WideBuild<T> run() {
        for (std::size_t i = binary_.size(); i > 0; --i) plan(i - 1);
        out_.bounds = binary_[0].bounds;
        out_.nodes.resize(1);
        pending_ = {{0, 0}};
        while (!pending_.empty()) {
            const Pending at = pending_.back();
            pending_.pop_back();
            fill(at);
        }
        return std::move(out_);
    }

  private:
    struct Pending {
        std::uint32_t wide, binary;
    };
    static constexpr std::size_t kWidth = WideNode<T>::kWidth;
    /// Visiting a node against testing a leaf; what empty slots cost in memory is in it.
    static constexpr float kNodeCost = 1.5F;

    /// For a subtree that is given 1 to 8 slots: what it costs at best, and how many of the slots
    /// its left half takes (0: it takes fewer slots than given; for one slot: it is one).
    struct Plan {
        std::array<float, kWidth> cost;
        std::array<std::uint8_t, kWidth> left;
        std::uint8_t split;  ///< of the 8 slots of its own node
    };

    void plan(std::size_t at) {
        const BinaryNode<T>& node = binary_[at];
        Plan& own = plans_[at];
        const auto area = static_cast<float>(half_area(node.bounds));
        own.left = {};
        own.split = 0;
        if (node.leaf()) {
            own.cost.fill(area);
            return;
        }
        const Plan& left = plans_[node.left];
        const Plan& right = plans_[node.left + 1];
        for (std::size_t slots_given = 2; slots_given <= kWidth; ++slots_given) {
            float best = std::numeric_limits<float>::infinity();
            for (std::size_t k = 1; k < slots_given; ++k) {
                const float cost = left.cost[k - 1] + right.cost[slots_given - k - 1];
                if (cost < best || own.left[slots_given - 1] == 0) {
                    best = cost;
                    own.left[slots_given - 1] = static_cast<std::uint8_t>(k);
                }
            }
            own.cost[slots_given - 1] = best;
        }
        own.split = own.left[kWidth - 1];
        own.cost[0] = own.cost[kWidth - 1] + area * kNodeCost;
        for (std::size_t i = 1; i < kWidth; ++i) {
            if (own.cost[i - 1] <= own.cost[i]) {
                own.cost[i] = own.cost[i - 1];
                own.left[i] = 0;
            }
        }
    }

    struct Share {
        std::uint32_t binary;
        std::size_t slots;
    };

    void fill(const Pending& at) {
        std::array<std::uint32_t, kWidth> children{};
        std::size_t count = 0;
        // At most one share waits for each slot.
        std::array<Share, kWidth> shares;
        std::size_t waiting = 0;
        const auto halve = [&](std::uint32_t node, std::size_t to_left, std::size_t of) {
            shares[waiting++] = {binary_[node].left + 1, of - to_left};
            shares[waiting++] = {binary_[node].left, to_left};
        };
        if (binary_[at.binary].leaf()) {
            children[count++] = at.binary;
        } else {
            halve(at.binary, plans_[at.binary].split, kWidth);
        }
        while (waiting > 0) {
            Share share = shares[--waiting];
            const Plan& plan = plans_[share.binary];
            while (share.slots > 1 && plan.left[share.slots - 1] == 0) --share.slots;
            if (share.slots == 1) {
                children[count++] = share.binary;
            } else {
                halve(share.binary, plan.left[share.slots - 1], share.slots);
            }
        }
        WideNode<T> node;
        const BoxBounds<T> empty;
        for (std::size_t i = 0; i < kWidth; ++i) {
            const BoxBounds<T>& b = i < count ? binary_[children[i]].bounds : empty;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                node.bounds[axis][i] = b.lo[axis];
                node.bounds[3 + axis][i] = b.hi[axis];
            }
            node.child[i] = i < count ? slot(children[i]) : ChildRef::inner(0);
        }
        out_.nodes[at.wide] = node;
    }

    ChildRef slot(std::uint32_t child) {
        const auto& from = binary_[child];
        if (!from.leaf()) {
            const auto wide = static_cast<std::uint32_t>(out_.nodes.size());
            pending_.push_back({wide, child});
            out_.nodes.resize(wide + std::size_t{1});
            return ChildRef::inner(wide);
        }
        const PrimitiveKind kind = items_[from.first].kind;
        std::uint32_t index = items_[from.first].index;
        if (kind == PrimitiveKind::kTriangle) {
            index = static_cast<std::uint32_t>(out_.triangle_blocks.size());
            out_.triangle_blocks.push_back({from.first, from.count});
        } else if (kind == PrimitiveKind::kSphere) {
            index = static_cast<std::uint32_t>(out_.sphere_blocks.size());
            out_.sphere_blocks.push_back({from.first, from.count});
        }
        return ChildRef::leaf(kind, index, from.count);
    }

    const std::vector<BinaryNode<T>>& binary_;
    const std::vector<BuildItem<T>>& items_;
    std::vector<Plan> plans_;
    WideBuild<T> out_;
    std::vector<Pending> pending_;
};

}  // namespace

template <typename T>
WideBuild<T> build_wide_tree(std::vector<BuildItem<T>>& items, const std::atomic<bool>* cancelled) {
    if (items.empty()) return {};
    const std::vector<BinaryNode<T>> binary = BinaryBuilder<T>(items, cancelled).run();
    if (is_set(cancelled)) return {};
    return Collapse<T>(binary, items).run();
}

template WideBuild<float> build_wide_tree(std::vector<BuildItem<float>>&, const std::atomic<bool>*);
template WideBuild<double> build_wide_tree(std::vector<BuildItem<double>>&,
                                           const std::atomic<bool>*);

}  // namespace cobble::renderer
