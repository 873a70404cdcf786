// SPDX-License-Identifier: MIT
#include "renderer/accel/wide_builder.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "renderer/accel/binary_builder.hpp"
#include "renderer/accel/half_area.hpp"

namespace cobble::renderer {

namespace {

/// Which binary nodes become the slots of which wide node: the cheapest of all ways, by dynamic
/// programming from the leaves up (Ylitie, Karras and Laine, Efficient Incoherent Ray Traversal on
/// GPUs Through Compressed Wide BVHs, 2017, section 4).
template <typename T>
class Collapse {
  public:
    Collapse(const BinaryTree<T>& tree, const std::vector<BuildItem<T>>& items)
        : tree_(tree), binary_(tree.nodes), items_(items), plans_(tree.nodes.size()) {}

    WideBuild<T> run(const BuildControl& control) {
        // Subtrees know nothing of each other; what is above them comes last, from below.
        const auto& starts = tree_.subtrees;
        control.for_each(starts.size(), [&](std::size_t i) {
            const std::size_t end = i + 1 < starts.size() ? starts[i + 1] : binary_.size();
            for (std::size_t at = end; at > starts[i]; --at) plan(at - 1);
        });
        for (std::size_t at = starts.front(); at > 0; --at) plan(at - 1);
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
        const PrimitiveKind kind = items_[from.first].kind();
        std::uint32_t index = items_[from.first].index();
        if (kind == PrimitiveKind::kTriangle) {
            index = static_cast<std::uint32_t>(out_.triangle_blocks.size());
            out_.triangle_blocks.push_back({from.first, from.count});
        } else if (kind == PrimitiveKind::kSphere) {
            index = static_cast<std::uint32_t>(out_.sphere_blocks.size());
            out_.sphere_blocks.push_back({from.first, from.count});
        }
        return ChildRef::leaf(kind, index, from.count);
    }

    const BinaryTree<T>& tree_;
    const std::vector<BinaryNode<T>>& binary_;
    const std::vector<BuildItem<T>>& items_;
    std::vector<Plan> plans_;
    WideBuild<T> out_;
    std::vector<Pending> pending_;
};

}  // namespace

template <typename T>
WideBuild<T> build_wide_tree(std::vector<BuildItem<T>>& items, const BuildControl& control) {
    if (items.empty()) return {};
    const BinaryTree<T> binary = build_binary_tree(items, control);
    if (control.stopped()) return {};
    return Collapse<T>(binary, items).run(control);
}

template WideBuild<float> build_wide_tree(std::vector<BuildItem<float>>&, const BuildControl&);
template WideBuild<double> build_wide_tree(std::vector<BuildItem<double>>&, const BuildControl&);

}  // namespace cobble::renderer
