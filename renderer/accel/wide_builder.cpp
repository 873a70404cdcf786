// SPDX-License-Identifier: MIT
#include "renderer/accel/wide_builder.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "renderer/accel/binary_builder.hpp"
#include "renderer/accel/half_area.hpp"
#include "renderer/accel/tree_limits.hpp"

namespace cobble::renderer {

namespace {

/// Which binary nodes become the slots of which wide node: the cheapest of all ways, by dynamic
/// programming from the leaves up (Ylitie, Karras and Laine, Efficient Incoherent Ray Traversal on
/// GPUs Through Compressed Wide BVHs, 2017, section 4).
template <typename T>
class Collapse {
  public:
    Collapse(const BinaryTree<T>& tree, const std::vector<BuildItem<T>>& items)
        : tree_(tree),
          binary_(tree.nodes.get()),
          items_(items),
          plans_(std::make_unique_for_overwrite<Plan[]>(tree.all / 2)) {}

    WideBuild<T> run(const BuildControl& control) {
        // Subtrees know nothing of each other; what is above them comes last, from below.
        control.for_each(tree_.subtrees.size(), [&](std::size_t i) {
            const auto range = tree_.subtrees[i];
            for (std::uint32_t at = range.end; at > range.begin; --at) plan(binary_[at - 1]);
        });
        for (std::uint32_t at = tree_.top; at > 0; --at) plan(binary_[at - 1]);
        out_.bounds = binary_[0].bounds();
        // Nodes have some six children; less is reserved than was written meanwhile.
        out_.nodes.reserve(tree_.leaves / 4 + 1);
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

    /// A leaf costs as much whatever it is given.
    static std::array<float, kWidth> leaf_cost(const BinaryNode<T>& node) {
        std::array<float, kWidth> cost;
        cost.fill(static_cast<float>(half_area(node.bounds())));
        return cost;
    }
    /// Not of a leaf.
    Plan& plan_of(const BinaryNode<T>& node) { return plans_[node.at / 2]; }

    void plan(const BinaryNode<T>& node) {
        if (node.leaf()) return;
        Plan& own = plan_of(node);
        const auto area = static_cast<float>(half_area(node.bounds()));
        own.left = {};
        const BinaryNode<T>& first = binary_[node.at];
        const BinaryNode<T>& second = binary_[node.at + 1];
        const std::array<float, kWidth> left =
            first.leaf() ? leaf_cost(first) : plan_of(first).cost;
        const std::array<float, kWidth> right =
            second.leaf() ? leaf_cost(second) : plan_of(second).cost;
        for (std::size_t slots_given = 2; slots_given <= kWidth; ++slots_given) {
            // A leaf takes one, and nothing costs less for being given less.
            const bool one_leaf = first.leaf() || second.leaf();
            std::size_t k = one_leaf && !first.leaf() ? slots_given - 1 : 1;
            const std::size_t last = one_leaf ? k : slots_given - 1;
            float best = left[k - 1] + right[slots_given - k - 1];
            own.left[slots_given - 1] = static_cast<std::uint8_t>(k);
            while (k < last) {
                ++k;
                const float cost = left[k - 1] + right[slots_given - k - 1];
                if (cost < best) {
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
            shares[waiting++] = {binary_[node].at + 1, of - to_left};
            shares[waiting++] = {binary_[node].at, to_left};
        };
        if (binary_[at.binary].leaf()) {
            children[count++] = at.binary;
        } else {
            halve(at.binary, plan_of(binary_[at.binary]).split, kWidth);
        }
        while (waiting > 0) {
            Share share = shares[--waiting];
            if (binary_[share.binary].leaf()) {
                children[count++] = share.binary;
                continue;
            }
            const Plan& plan = plan_of(binary_[share.binary]);
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
            const BoxBounds<T> b = i < count ? binary_[children[i]].bounds() : empty;
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
        const PrimitiveKind kind = items_[from.at].kind();
        std::uint32_t index = items_[from.at].index();
        if (kind == PrimitiveKind::kTriangle) {
            index = static_cast<std::uint32_t>(out_.triangle_blocks.size());
            out_.triangle_blocks.push_back({from.at, from.count});
        } else if (kind == PrimitiveKind::kSphere) {
            index = static_cast<std::uint32_t>(out_.sphere_blocks.size());
            out_.sphere_blocks.push_back({from.at, from.count});
            return ChildRef::leaf(kind, index, 1);
        }
        return ChildRef::leaf(kind, index, from.count);
    }

    const BinaryTree<T>& tree_;
    const BinaryNode<T>* binary_;
    const std::vector<BuildItem<T>>& items_;
    std::unique_ptr<Plan[]> plans_;  ///< a pair of children each
    WideBuild<T> out_;
    std::vector<Pending> pending_;
};

}  // namespace

template <typename T>
WideBuild<T> build_wide_tree(std::vector<BuildItem<T>>& items, const BuildControl& control) {
    if (items.empty()) return {};
    require_room(items.size());
    const BinaryTree<T> binary = build_binary_tree(items, control);
    if (control.stopped()) return {};
    return Collapse<T>(binary, items).run(control);
}

template WideBuild<float> build_wide_tree(std::vector<BuildItem<float>>&, const BuildControl&);
template WideBuild<double> build_wide_tree(std::vector<BuildItem<double>>&, const BuildControl&);

}  // namespace cobble::renderer
