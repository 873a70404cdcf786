// SPDX-License-Identifier: MIT
// The fast core's tree: the same to the last bit, whoever builds it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "renderer/geometry/bounds.hpp"
#include "renderer/intersect/instruction_set.hpp"
#include "renderer/job/build_on.hpp"
#include "tests/hard/scenes.hpp"
#include "tests/support/with_instruction_set.hpp"

namespace cobble::test {

namespace {

using renderer::BoxBounds;
using renderer::BuildControl;

/// More things than one worker takes at a time, and than are sorted into a grid's cells, of each
/// kind that has bounds, some in one place: a share of `together` in all. Boxes stand on a lattice,
/// where many middles are within a rounding of where bins end.
ir::Scene crowd(double together) {
    SceneMaker make;
    Random random(5);
    const auto near = [&](Vec3d at) { return at + random.direction() * 0.2; };
    for (int i = 0; i < 13000; ++i) {
        const Vec3d at =
            random.unit() < together ? Vec3d{1, 2, 3} : random.direction() * random.in(0, 9);
        make.triangle(at, near(at), near(at));
        if (i % 3 == 0) make.sphere(at, random.in(0.01, 0.2));
        if (i % 2 == 0) {
            const Vec3d corner =
                Vec3d{double(i / 2 % 19), double(i / 38 % 18), double(i / 684 % 20)} * 0.1;
            make.box(corner, corner + Vec3d{0.1, 0.1, 0.1});
        }
    }
    return make.scene;
}

template <typename T>
renderer::PreparedScene<T> prepare_fast(const ir::Scene& scene, const BuildControl& build) {
    renderer::PrepareOptions options;
    options.acceleration = renderer::Acceleration::kFast;
    options.build = build;
    return renderer::prepare<T>(scene, options);
}

template <typename T>
renderer::WideTree<T> tree_of(const ir::Scene& scene, const BuildControl& build) {
    return prepare_fast<T>(scene, build).geometry.wide;
}

/// Goes through a tree over objects that are a triangle, a sphere or a box each.
template <typename T>
class Inventory {
  public:
    Inventory(const ir::Scene& scene, const BuildControl& build)
        : scene_(scene), prepared_(prepare_fast<T>(scene, build)), seen_(scene.objects.size()) {
        const auto& nodes = prepared_.geometry.wide.nodes;
        // Children come behind their parents.
        std::vector<BoxBounds<T>> boxes(nodes.size());
        for (std::size_t i = nodes.size(); i > 0; --i) boxes[i - 1] = look_at(nodes[i - 1], boxes);
        if (boxes[0] != prepared_.geometry.wide.bounds) wrong_boxes_ += 1;
    }

    /// Objects that are not there once, and slots whose box is not that of what they lead to.
    [[nodiscard]] std::ptrdiff_t not_once() const {
        return std::ssize(seen_) - std::count(seen_.begin(), seen_.end(), 1);
    }
    [[nodiscard]] int wrong_boxes() const { return wrong_boxes_; }

  private:
    BoxBounds<T> look_at(const renderer::WideNode<T>& node,
                         const std::vector<BoxBounds<T>>& boxes) {
        BoxBounds<T> all;
        for (std::size_t i = 0; i < renderer::WideNode<T>::kWidth; ++i) {
            BoxBounds<T> slot;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                slot.lo[axis] = node.bounds[axis][i];
                slot.hi[axis] = node.bounds[3 + axis][i];
            }
            if (slot.empty()) continue;
            const renderer::ChildRef child = node.child[i];
            const auto* const nodes = prepared_.geometry.wide.nodes.data();
            const BoxBounds<T> held = child.is_inner()
                                          ? boxes[std::size_t(&child.node_in(nodes) - nodes)]
                                          : held_by(child);
            if (held != slot) wrong_boxes_ += 1;
            all.add(slot);
        }
        return all;
    }

    BoxBounds<T> held_by(renderer::ChildRef leaf) {
        const auto& g = prepared_.geometry;
        if (leaf.kind() == renderer::PrimitiveKind::kBox) {
            const ir::ObjectId id = renderer::box_object(leaf);
            seen_[id.value] += 1;
            const ir::Box& box = scene_.boxes[scene_.objects[id.value].shape];
            return {prepared_.to_local(box.min), prepared_.to_local(box.max)};
        }
        BoxBounds<T> all;
        if (leaf.kind() == renderer::PrimitiveKind::kTriangle) {
            const auto& block = g.wide.triangles[leaf.index()];
            for (std::uint32_t lane = 0; lane < leaf.count(); ++lane) {
                seen_[block.object[lane].value] += 1;
                for (const auto& corner : block.vertices) {
                    all.add(Vec3<T>{corner[0][lane], corner[1][lane], corner[2][lane]});
                }
            }
            return all;
        }
        const auto& block = g.wide.spheres[leaf.index()];
        for (std::uint32_t lane = 0; lane < renderer::kSphereLanes; ++lane) {
            if (!block.object[lane].valid()) break;
            seen_[block.object[lane].value] += 1;
            const Vec3<T> center{block.center[0][lane], block.center[1][lane],
                                 block.center[2][lane]};
            all.add(renderer::bounds_of(center, block.radius[lane]));
        }
        return all;
    }

    const ir::Scene& scene_;
    renderer::PreparedScene<T> prepared_;
    std::vector<int> seen_;
    int wrong_boxes_ = 0;
};

template <typename T>
void check_whole(double together) {
    CAPTURE(together);
    const ir::Scene scene = crowd(together);
    const auto workers = renderer::make_thread_scheduler(2);
    for (const std::string& name : renderer::instruction_sets()) {
        CAPTURE(name);
        const WithInstructionSet with(name);
        const Inventory<T> inventory(scene, renderer::build_on(*workers));
        CHECK(inventory.not_once() == 0);
        CHECK(inventory.wrong_boxes() == 0);
    }
}

template <typename U>
bool same_bytes(const renderer::LargeVector<U>& a, const renderer::LargeVector<U>& b) {
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
    const ir::Scene scene = crowd(0.02);
    const auto alone = tree_of<T>(scene, {});
    REQUIRE(alone.triangles.size() > 2000);
    REQUIRE(alone.spheres.size() > 250);
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
            const WithInstructionSet with(name);
            check_same(alone, tree_of<T>(scene, {}));
        }
    }
}

}  // namespace

TEST_CASE("a tree is the same however it is built, float") { compare_builders<float>(); }
TEST_CASE("a tree is the same however it is built, double") { compare_builders<double>(); }

TEST_CASE_TEMPLATE("a tree holds everything once, in boxes that fit", T, float, double) {
    check_whole<T>(0.02);
    check_whole<T>(0.98);
}

}  // namespace cobble::test
