// SPDX-License-Identifier: MIT
// Loops over columns, at every instruction set, draw what the reference draws ray by ray.
#include <doctest/doctest.h>

#include <string>

#include "tests/render/everything.hpp"
#include "tests/render/same.hpp"
#include "tests/support/with_instruction_set.hpp"

using namespace cobble;
using namespace cobble::test;
using renderer::Acceleration;

namespace {

/// Every form that the loops compute, in plain materials, some of them shiny; and one that they
/// leave to the reference's code between them.
SceneBuilder forms() {
    SceneBuilder b;
    b.background({0.25, 0.5, 0.75}, {0.1, 0.2, 0.1}).camera({0, 2, 9}, {0, -0.15, -1}, 0.6);
    b.material({0.9, 0.3, 0.2});
    b.sphere({-2, 1, 0}, 0.8).box({-0.9, 0, 0.5}, {0.2, 1.1, 1.5});
    b.material({0.2, 0.3, 0.9}, {0.6, 0.5, 0.4}, 17);
    b.mesh(smooth_tetrahedron()).sphere({2.2, 1.1, 0.5}, 0.9);
    ir::Mesh flat = smooth_tetrahedron();
    for (auto& face : flat.faces) {
        for (auto& corner : face.corners) corner.normal = ir::Mesh::kNone;
    }
    for (Vec3d& p : flat.positions) p = p * 0.6 + Vec3d{1, 0.5, 2};
    b.material({0.5, 0.6, 0.1}, {1, 1, 1}, 0.5);
    // Normals at its vertices that are none.
    ir::Mesh dull = smooth_tetrahedron();
    for (Vec3d& n : dull.normals) n = {};
    for (Vec3d& p : dull.positions) p = p * 0.4 + Vec3d{-0.6, 2.2, 0.5};
    b.mesh(flat).mesh(dull).triangle({-3, 0, -2}, {3, 0, -2}, {0, 4, -3});
    b.plane({0, 1, 0}, 0);
    b.point_light({-3, 6, 4}, {0.7, 0.6, 0.5});
    b.point_light({4, 3, 5}, {0.3, 0.4, 0.5}, 0, 0.05);
    b.sun({0.4, -1, -0.3}, {0.2, 0.2, 0.2});
    return b;
}

void check_both(const ir::Scene& scene, renderer::Settings s) {
    s.acceleration = Acceleration::kBvh;
    const Rendered reference = render(scene, s);
    s.acceleration = Acceleration::kFast;
    const Rendered fast = render(scene, s);
    CHECK(same(reference.picture, fast.picture));
    CHECK(same_rays(reference.stats.counters, fast.stats.counters));
}

}  // namespace

TEST_CASE("loops over columns draw the reference's picture at every instruction set") {
    SceneBuilder b = forms();
    for (const std::string& name : renderer::instruction_sets()) {
        CAPTURE(name);
        const WithInstructionSet only(name);
        for (const std::uint32_t bounces : {0U, 2U}) {
            CAPTURE(bounces);
            renderer::Settings s = settings(40, 30, 5);
            s.bounces = bounces;
            for (const auto filter : {renderer::PixelFilter::kBox, renderer::PixelFilter::kTent}) {
                s.filter = filter;
                check_both(b.scene(), s);
            }
            s.effects = without(all_effects(), Effect::kShadows);
            check_both(b.scene(), s);
            s.want_normals = s.want_depth = s.want_albedo = true;
            s.precision = renderer::Precision::kDouble;
            check_both(b.scene(), s);
        }
    }
}

TEST_CASE("what is not plain joins the loops at every instruction set") {
    SceneBuilder b = everything();
    for (const std::string& name : renderer::instruction_sets()) {
        CAPTURE(name);
        const WithInstructionSet only(name);
        for (const std::uint32_t bounces : {0U, 4U}) {
            renderer::Settings s = settings(24, 18, 3);
            s.bounces = bounces;
            check_both(b.scene(), s);
        }
    }
}
