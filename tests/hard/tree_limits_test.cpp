// SPDX-License-Identifier: MIT
// More than a tree can hold is refused.
#include "renderer/accel/tree_limits.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <new>
#include <string>

#include "tests/hard/scenes.hpp"

namespace cobble::test {

TEST_CASE("more things than a tree's numbers reach are refused before memory is taken") {
    const std::uint64_t most = renderer::kMostThings;
    CHECK(most <= renderer::ChildRef::kMostIndex);
    CHECK(most - 1 <= renderer::ChildRef::kMostNode);
    CHECK_NOTHROW(renderer::require_room(most));
    std::string said;
    try {
        renderer::require_room(most + 1);
    } catch (const std::bad_alloc& problem) {
        said = problem.what();
    }
    CHECK(said == "a tree of 76695846 triangles and other shapes: at most 76695845 can be held");
    // One mesh named so often that the scene takes little memory.
    SceneMaker make;
    Solid heap;
    heap.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    heap.faces.resize(1000000, {0, 1, 2});
    const auto mesh = make.mesh(heap);
    for (int i = 0; i < 76; ++i) make.again(mesh);
    CHECK_THROWS_AS(renderer::prepare<float>(make.scene), renderer::TooManyThings);
    renderer::PrepareOptions fast;
    fast.acceleration = renderer::Acceleration::kFast;
    CHECK_THROWS_AS(renderer::prepare<float>(make.scene, fast), renderer::TooManyThings);
    CHECK_THROWS_AS(renderer::prepare<double>(make.scene, fast), renderer::TooManyThings);
}

}  // namespace cobble::test
