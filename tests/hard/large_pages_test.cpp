// SPDX-License-Identifier: MIT
#include "renderer/accel/large_pages.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>

#include "renderer/accel/wide_tree.hpp"

namespace cobble::test {

namespace {

using Node = renderer::WideNode<float>;
using Nodes = renderer::LargeVector<Node>;

template <std::size_t kAlignment>
bool is_aligned(const void* memory) {
    return reinterpret_cast<std::uintptr_t>(memory) % kAlignment == 0;
}

constexpr std::size_t kPage = std::size_t{2} << 20;

}  // namespace

TEST_CASE("memory for trees is aligned, small or in large pages") {
    for (const std::size_t bytes : {sizeof(Node), kPage / 4, kPage / 2 + sizeof(Node), 3 * kPage}) {
        CAPTURE(bytes);
        const Nodes nodes(bytes / sizeof(Node));
        CHECK(is_aligned<alignof(Node)>(nodes.data()));
        if (bytes >= kPage / 2 + sizeof(Node)) CHECK(is_aligned<kPage>(nodes.data()));
    }
}

TEST_CASE("a tree that grows from small memory into large pages keeps what it holds") {
    Nodes nodes;
    for (std::size_t i = 0; i < 3 * kPage / sizeof(Node); ++i) {
        nodes.emplace_back().bounds[0][i % Node::kWidth] = static_cast<float>(i);
    }
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].bounds[0][i % Node::kWidth] != static_cast<float>(i)) wrong += 1;
    }
    CHECK(wrong == 0);
    const void* const at = nodes.data();
    const Nodes moved = std::move(nodes);
    CHECK(moved.data() == at);
}

TEST_CASE("more memory than there can be is refused, not wrapped around") {
    renderer::LargePages<Node> pages;
    CHECK_THROWS_AS(static_cast<void>(pages.allocate(static_cast<std::size_t>(-1) / sizeof(Node))),
                    std::bad_alloc);
}

}  // namespace cobble::test
