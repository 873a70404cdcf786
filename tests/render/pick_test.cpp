// SPDX-License-Identifier: MIT
#include "renderer/pick/pick.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "tests/render/scene_builder.hpp"

using namespace cobble;
using namespace cobble::test;
using renderer::PickNode;
using renderer::PickTree;

TEST_CASE("a pick names the object, its place and each light") {
    SceneBuilder b;
    b.background({}, {0.1, 0.1, 0.1});
    b.material({0.5, 0.5, 0.5});
    b.plane({0, 0, 1}, 0);
    b.sphere({3, 0, 3}, 0.5);
    b.point_light({6, 0, 6}, {1, 1, 1});  // hidden by the sphere
    b.sun({0, 0, -1}, {1, 0.5, 0});
    b.sun({0, 0, 1}, {1, 1, 1});  // from behind
    const PickTree tree = renderer::pick(b.scene(), settings(9, 9, 64), 4, 4);
    REQUIRE(tree.nodes.size() == 1);
    const PickNode& node = tree.nodes[0];
    CHECK(node.hit);
    CHECK(node.kind == PickNode::Kind::kCamera);
    CHECK(node.object == ir::ObjectId{0});
    CHECK(node.material == ir::MaterialId{0});
    CHECK(node.t == doctest::Approx(10));
    CHECK(math::length(node.position) < 1e-12);
    CHECK(node.normal == Vec3d{0, 0, 1});
    CHECK(node.origin == Vec3d{0, 0, 10});
    REQUIRE(node.lights.size() == 3);
    CHECK_FALSE(node.lights[0].visible);
    CHECK(node.lights[1].visible);
    CHECK(node.lights[1].contribution == Color{0.5, 0.25, 0});
    CHECK_FALSE(node.lights[2].visible);
    CHECK(node.color.x == doctest::Approx(0.55));
}

TEST_CASE("a pick of nothing is the background") {
    SceneBuilder b;
    b.background({0.1, 0.2, 0.3});
    const PickTree tree = renderer::pick(b.scene(), settings(9, 9), 0, 8);
    REQUIRE(tree.nodes.size() == 1);
    CHECK_FALSE(tree.nodes[0].hit);
    CHECK(tree.nodes[0].color == Color{0.1F, 0.2F, 0.3F});
}

TEST_CASE("the tree's colour is the pixel's, lens, lights and time at their middle") {
    SceneBuilder b;
    b.background({0.3, 0.4, 0.6}, {0.1, 0.1, 0.1});
    b.camera({0, 2, 8}, {0, -0.2, -1}, 0.7).lens(0.3, 5);
    b.material({0.8, 0.6, 0.4}, {0.3, 0.3, 0.3}, 5);
    b.plane({0, 1, 0}, 0);
    b.material({0.1, 0.1, 0.1}, {0.9, 0.8, 0.7}, 30, 1.5);
    b.sphere({0, 1, 0}, 1);
    b.box({-3, 0, -1}, {-1.5, 2, 0});
    b.point_light({3, 6, 4}, {0.9, 0.9, 0.9}, 1);
    renderer::Settings s = settings(24, 18, 1);
    s.precision = renderer::Precision::kDouble;
    ir::Effects middle = without(all_effects(), Effect::kDepthOfField);
    middle = without(without(middle, Effect::kSoftShadows), Effect::kMotionBlur);
    renderer::Settings exact = s;
    exact.effects = middle;
    const Rendered picture = render(b.scene(), exact);
    std::size_t largest = 0;
    for (std::uint32_t y = 0; y < 18; ++y) {
        for (std::uint32_t x = 0; x < 24; ++x) {
            const PickTree tree = renderer::pick(b.scene(), s, x, y);
            const Color color = tree.nodes[0].color;
            CHECK(math::length(color - picture.color(x, y)) < 1e-6);
            largest = std::max(largest, tree.nodes.size());
            // Children follow their parents, and every node but the first is one node's child.
            std::vector<int> parents(tree.nodes.size(), 0);
            for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
                for (const std::uint32_t child : tree.nodes[i].children) {
                    CHECK(child > i);
                    CHECK(tree.nodes[child].depth == tree.nodes[i].depth + 1);
                    ++parents[child];
                }
            }
            for (std::size_t i = 1; i < parents.size(); ++i) CHECK(parents[i] == 1);
        }
    }
    CHECK(largest > 8);
}

TEST_CASE("what is picked is what a picture of the same precision shows, right or wrong") {
    // A ball between two of float's steps, through a long lens.
    SceneBuilder b;
    b.background({0.2, 0.4, 0.8}, {0.5, 0.5, 0.5});
    b.camera({0, 0, 0}, {1, 1, 1}, 1e-6);
    b.material({0.9, 0.5, 0.1});
    b.sphere({6e6 + 0.3, 6e6 + 0.2, 6e6}, 2);
    b.sphere({-3, 0, 0}, 1);
    std::vector<std::vector<bool>> hits_in;
    for (const auto precision : {renderer::Precision::kFloat, renderer::Precision::kDouble}) {
        CAPTURE(static_cast<int>(precision));
        renderer::Settings s = settings(8, 8, 1);
        s.precision = precision;
        const Rendered picture = render(b.scene(), s);
        std::vector<bool>& hits = hits_in.emplace_back();
        for (std::uint32_t at = 0; at < 64; ++at) {
            const PickTree tree = renderer::pick(b.scene(), s, at % 8, at / 8);
            hits.push_back(tree.nodes[0].object == ir::ObjectId{0});
            CHECK(math::length(tree.nodes[0].color - picture.color(at % 8, at / 8)) < 1e-6);
        }
    }
    CHECK(hits_in[0] != hits_in[1]);
}

TEST_CASE("row 32: leaving glass leads to index 1 again, nested or from inside") {
    // Straight through the middle of everything: which shells stand in one another must not bend
    // the ray, and each refracted ray goes on straight.
    for (const bool inside : {false, true}) {
        SceneBuilder b;
        b.background({0, 1, 0});
        b.camera({0, 0, inside ? 0.1 : 10.0}, {0, 0, -1}, 0.5);
        b.material({0, 0, 0}, {1, 1, 1}, 0, 1.5);
        b.sphere({0, 0, 0}, 3);
        b.material({0, 0, 0}, {1, 1, 1}, 0, 1.33);
        b.sphere({0, 0, 0}, 2);
        b.sphere({0, 0, 0}, 2);  // the same surface twice
        renderer::Settings s = settings(1, 1, 1);
        s.bounces = 12;
        s.effects = without(all_effects(), Effect::kReflection);
        const PickTree tree = renderer::pick(b.scene(), s, 0, 0);
        const PickNode& last = tree.nodes.back();
        CHECK_FALSE(last.hit);
        CHECK(last.kind == PickNode::Kind::kRefracted);
        CHECK(last.direction.z == doctest::Approx(-1));
        // Twice through each of two shells, or once from the middle: the two that coincide are
        // within a start's distance of each other and count as one, in and out alike.
        CHECK(last.depth == (inside ? 2 : 4));
        for (const PickNode& node : tree.nodes) CHECK(std::isfinite(node.color.x));
    }
}

TEST_CASE("a hopeless tree is cut, not followed to the end of memory") {
    SceneBuilder b;
    b.background({1, 1, 1});
    b.material({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, 0, 1.5);
    for (int i = 0; i < 8; ++i) b.box({-50, -50, -2.0 * i - 1}, {50, 50, -2.0 * i});
    renderer::Settings s = settings(3, 3);
    s.bounces = 1000;
    const PickTree tree = renderer::pick(b.scene(), s, 1, 1);
    CHECK(tree.nodes.size() == renderer::kMostPickNodes);
    CHECK(tree.rays == renderer::kMostPickRays);
    CHECK_FALSE(tree.complete);
}

TEST_CASE("rays beyond the tree are in the colours") {
    SceneBuilder b;
    b.background({1, 1, 1});
    // White glass that takes nothing away, seen from within: the rays' parts add up to all light.
    b.material({0, 0, 0}, {1, 1, 1}, 0, 1.5);
    for (int i = 0; i < 8; ++i) b.box({-50, -50, -2.0 * i - 1}, {50, 50, -2.0 * i});
    renderer::Settings s = settings(1, 1, 1);
    s.bounces = 20;
    const PickTree tree = renderer::pick(b.scene(), s, 0, 0);
    CHECK(tree.complete);
    CHECK(tree.nodes.size() == renderer::kMostPickNodes);
    CHECK(tree.rays > renderer::kMostPickNodes);
    const auto rendered = render(b.scene(), s);
    CHECK(tree.nodes[0].color.x == doctest::Approx(rendered.color(0, 0).x).epsilon(1e-6));
}
