// SPDX-License-Identifier: MIT
// Memory for trees: where it begins, and that too much of it is refused.
#include "renderer/accel/large_pages.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <utility>

#include "renderer/accel/wide_tree.hpp"

namespace cobble::test {

namespace {

using Node = renderer::WideNode<float>;
using Nodes = renderer::LargeVector<Node>;

}  // namespace

TEST_CASE("memory of any size is aligned, and written to its end") {
    constexpr std::size_t kMiB = std::size_t{1} << 20;
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{224}, kMiB - 1,
                                    kMiB, 2 * kMiB, 2 * kMiB + 1, 5 * kMiB}) {
        for (const std::size_t alignment : {std::size_t{16}, std::size_t{32}, std::size_t{64}}) {
            CAPTURE(bytes);
            void* const memory = renderer::allocate_large(bytes, alignment);
            CHECK(reinterpret_cast<std::uintptr_t>(memory) % alignment == 0);
            std::memset(memory, 1, bytes);
            renderer::free_large(memory, bytes, alignment);
        }
    }
}

TEST_CASE("more memory than can be counted is refused") {
    constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
    for (const std::size_t less : {0U, 1U, 63U, 1U << 20U}) {
        CHECK_THROWS_AS(renderer::allocate_large(kMost - less, 64), std::bad_alloc);
    }
}

TEST_CASE("a tree that grows from small memory into large pages keeps what it holds") {
    Nodes nodes;
    for (std::size_t i = 0; i < (std::size_t{6} << 20U) / sizeof(Node); ++i) {
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
