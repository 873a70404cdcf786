// SPDX-License-Identifier: MIT
// The fast core's tree: the same to the last bit, whoever builds it.
#include <doctest/doctest.h>

#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "renderer/intersect/instruction_set.hpp"
#include "renderer/job/build_on.hpp"
#include "tests/hard/scenes.hpp"

namespace cobble::test {

namespace {

using renderer::BuildControl;

/// More things than one worker takes at a time, of each kind that has bounds, some in one place.
ir::Scene crowd() {
    SceneMaker make;
    Random random(5);
    const auto near = [&](Vec3d at) { return at + random.direction() * 0.2; };
    for (int i = 0; i < 9000; ++i) {
        const Vec3d at = i % 50 == 0 ? Vec3d{1, 2, 3} : random.direction() * random.in(0, 9);
        make.triangle(at, near(at), near(at));
        if (i % 3 == 0) make.sphere(at, random.in(0.01, 0.2));
        if (i % 4 == 0) make.box(at, at + Vec3d{0.1, 0.2, random.in(0.1, 0.3)});
    }
    return make.scene;
}

template <typename T>
renderer::WideTree<T> tree_of(const ir::Scene& scene, const BuildControl& build) {
    renderer::PrepareOptions options;
    options.acceleration = renderer::Acceleration::kFast;
    options.build = build;
    return renderer::prepare<T>(scene, options).geometry.wide;
}

template <typename U>
bool same_bytes(const std::vector<U>& a, const std::vector<U>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(U)) == 0;
}

template <typename T>
void check_same(const renderer::WideTree<T>& a, const renderer::WideTree<T>& b) {
    CHECK(same_bytes(a.nodes, b.nodes));
    CHECK(same_bytes(a.triangles, b.triangles));
    CHECK(same_bytes(a.spheres, b.spheres));
}

template <typename T>
void compare_builders() {
    const ir::Scene scene = crowd();
    const auto alone = tree_of<T>(scene, {});
    REQUIRE(alone.triangles.size() > 2000);
    REQUIRE(alone.spheres.size() > 500);
    SUBCASE("in any order") {
        std::size_t parts = 0;
        const BuildControl backward{
            nullptr, [&](std::size_t count, const std::function<void(std::size_t)>& work) {
                parts += count;
                for (std::size_t i = count; i > 0; --i) work(i - 1);
            }};
        check_same(alone, tree_of<T>(scene, backward));
        CHECK(parts > 8);
    }
    SUBCASE("by several threads") {
        for (const std::uint32_t threads : {2U, 3U, 7U}) {
            const auto workers = renderer::make_thread_scheduler(threads);
            check_same(alone, tree_of<T>(scene, renderer::build_on(*workers)));
        }
    }
    SUBCASE("by every instruction set") {
        for (const std::string& name : renderer::instruction_sets()) {
            CAPTURE(name);
            REQUIRE(renderer::use_instruction_set(name));
            check_same(alone, tree_of<T>(scene, {}));
        }
        renderer::use_instruction_set("");
    }
}

}  // namespace

TEST_CASE("a tree is the same however it is built, float") { compare_builders<float>(); }
TEST_CASE("a tree is the same however it is built, double") { compare_builders<double>(); }

}  // namespace cobble::test
