// SPDX-License-Identifier: MIT
// The fast core's tree over what gives a heuristic nothing to go by.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/accel/binary_builder.hpp"
#include "renderer/accel/wide_builder.hpp"
#include "tests/hard/scenes.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

using renderer::BuildItem;
using renderer::PrimitiveKind;

constexpr PrimitiveKind kKinds[] = {PrimitiveKind::kTriangle, PrimitiveKind::kSphere,
                                    PrimitiveKind::kBox};

/// Ways to give a builder a hard time; each a number of items in boxes of its own making.
enum class Heap : std::uint8_t {
    kEqualBoxes,   ///< one box, again and again
    kOneMiddle,    ///< boxes of all sizes in each other, around one middle
    kToACorner,    ///< ever nearer to a corner and smaller: best peeled off one by one
    kAllKinds,     ///< triangles, spheres and boxes in turn, all in one box
    kMostlyEqual,  ///< one box, but for one in a thousand
};
constexpr Heap kHeaps[] = {Heap::kEqualBoxes, Heap::kOneMiddle, Heap::kToACorner, Heap::kAllKinds,
                           Heap::kMostlyEqual};

std::string name_of(Heap heap) {
    const char* const names[] = {"equal boxes", "boxes around one middle", "boxes toward a corner",
                                 "things of all kinds in one box", "equal boxes but for a few"};
    return names[static_cast<std::size_t>(heap)];
}

template <typename T>
std::vector<BuildItem<T>> items_of(Heap heap, PrimitiveKind kind, std::uint32_t count) {
    std::vector<BuildItem<T>> items;
    items.reserve(count);
    Random random(42);
    for (std::uint32_t i = 0; i < count; ++i) {
        Vec3d at{1, 2, 3};
        double size = 1;
        switch (heap) {
            case Heap::kOneMiddle:
                size = random.in(0.01, 1);
                break;
            case Heap::kToACorner:
                size = std::ldexp(1.0, -static_cast<int>(i % 100));
                at = {size, size, 0};
                break;
            case Heap::kMostlyEqual:
                if (i % 1000 == 999) at = random.point(1000);
                break;
            default:
                break;
        }
        const Vec3d half = Vec3d{0.5, 0.25, 0.5} * size;
        const renderer::BoxBounds<T> box{(at - half).to<T>(), (at + half).to<T>()};
        items.emplace_back(box, heap == Heap::kAllKinds ? kKinds[i % 3] : kind, i);
    }
    return items;
}

/// What a tree holds, and how deep it is.
struct Census {
    std::size_t not_once = 0;        ///< items that it does not hold once
    std::size_t before_parents = 0;  ///< children whose nodes do not come behind theirs
    std::uint32_t levels = 0;
};

template <typename T>
Census census(const renderer::WideBuild<T>& tree, const std::vector<BuildItem<T>>& items) {
    std::vector<int> held(items.size());
    Census result;
    std::vector<std::uint32_t> level(tree.nodes.size(), 1);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        result.levels = std::max(result.levels, level[i]);
        const auto& node = tree.nodes[i];
        for (std::size_t slot = 0; slot < renderer::WideNode<T>::kWidth; ++slot) {
            if (!(node.bounds[0][slot] <= node.bounds[3][slot])) continue;
            const renderer::ChildRef child = node.child[slot];
            if (child.is_inner()) {
                const auto at =
                    static_cast<std::size_t>(&child.node_in(tree.nodes.data()) - tree.nodes.data());
                result.before_parents += at > i ? 0 : 1;
                level[at] = level[i] + 1;
            } else if (child.kind() == PrimitiveKind::kBox) {
                held[child.index()] += 1;
            } else {
                const auto& blocks = child.kind() == PrimitiveKind::kTriangle ? tree.triangle_blocks
                                                                              : tree.sphere_blocks;
                const renderer::LeafRange range = blocks[child.index()];
                for (std::uint32_t k = 0; k < range.count; ++k) {
                    held[items[range.first + k].index()] += 1;
                }
            }
        }
    }
    result.not_once =
        items.size() - static_cast<std::size_t>(std::count(held.begin(), held.end(), 1));
    return result;
}

/// How many items building the binary tree looked at: each node looks at all that are below it.
template <typename T>
std::uint64_t items_looked_at(std::vector<BuildItem<T>> items) {
    const auto tree = renderer::build_binary_tree(items, {});
    struct Waiting {
        std::uint32_t node, depth;
    };
    // An item is looked at once for each node above it, and once in its leaf.
    std::uint64_t sum = 0;
    std::vector<Waiting> waiting = {{0, 1}};
    while (!waiting.empty()) {
        const auto [at, depth] = waiting.back();
        waiting.pop_back();
        const auto& node = tree.nodes[at];
        if (node.leaf()) {
            sum += std::uint64_t{node.count} * depth;
        } else {
            waiting.push_back({node.at, depth + 1});
            waiting.push_back({node.at + 1, depth + 1});
        }
    }
    return sum;
}

template <typename T>
void check_heaps(std::uint32_t count) {
    for (const Heap heap : kHeaps) {
        for (const PrimitiveKind kind : kKinds) {
            if (heap == Heap::kAllKinds && kind != kKinds[0]) continue;
            CAPTURE(name_of(heap));
            CAPTURE(static_cast<int>(kind));
            auto items = items_of<T>(heap, kind, count);
            const auto tree = renderer::build_wide_tree(items);
            const Census found = census(tree, items);
            CHECK(found.not_once == 0);
            CHECK(found.before_parents == 0);
            CHECK(found.levels <= renderer::kMaxTreeDepth);
            CHECK(tree.nodes.size() < count);
            if (kind == kKinds[0]) {
                record(42, counted(count) + " " + name_of(heap) + ": " + counted(found.levels) +
                               " levels of the fast core's tree, " +
                               std::string(name_of_type<T>()));
            }
        }
    }
}

}  // namespace

TEST_CASE_TEMPLATE("row 42: the fast core's tree over nothing and over one thing", T, float,
                   double) {
    std::vector<BuildItem<T>> none;
    CHECK(renderer::build_wide_tree(none).nodes.empty());
    for (const PrimitiveKind kind : kKinds) {
        auto one = items_of<T>(Heap::kEqualBoxes, kind, 1);
        const auto tree = renderer::build_wide_tree(one);
        const Census found = census(tree, one);
        CHECK(found.not_once == 0);
        CHECK(found.levels == 1);
        CHECK(tree.bounds == one[0].bounds());
    }
}

TEST_CASE("row 42: the fast core's tree over a million things in one place") {
    check_heaps<float>(1000000);
    check_heaps<double>(100000);
}

TEST_CASE("row 42: the work of building grows as n log n, however the things lie") {
    for (const Heap heap : kHeaps) {
        CAPTURE(name_of(heap));
        const std::uint32_t few = 1U << 12;
        const std::uint32_t many = 1U << 18;
        const auto work = [&](std::uint32_t count) {
            return static_cast<double>(
                items_looked_at(items_of<float>(heap, PrimitiveKind::kBox, count)));
        };
        // By the ratio of n log n, and some room for what is rounded up. What a heuristic peels
        // off one by one is bounded by the level from which on items are halved.
        CHECK(work(many) <= work(few) * 64 * (18.0 / 12) * 1.25);
        CHECK(work(many) <= many * (renderer::kHalvingDepth + 18.0));
    }
}

}  // namespace cobble::test
