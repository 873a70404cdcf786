// SPDX-License-Identifier: MIT
// Triangles of extreme shape and size: rows 9, 10 and 11 of the hard cases.
#include <doctest/doctest.h>

#include "tests/hard/scenes.hpp"
#include "tests/oracle/exact.hpp"

namespace cobble::test {

TEST_CASE("row 9: a sliver's t is that of its plane, and its hits lie in its box") {
    Random random(9);
    int hits = 0;
    double worst = 0;
    int outside = 0;
    for (int i = 0; i < 40000; ++i) {
        const double aspect = std::pow(10.0, random.in(2, 12));
        const Vec3d a = random.point(1);
        const Vec3d along = random.direction();
        const Vec3d side = normalize(cross(along, random.direction()));
        SceneMaker make;
        make.triangle(a, a + along, a + along * random.unit() + side * (1 / aspect));
        const auto scene = renderer::prepare<float>(make.scene);
        if (!scene.notes.empty()) continue;  // narrowed to a line
        const auto& v = scene.geometry.triangles[0].vertices;
        // Aimed at the middle, from all around: grazing rays among them.
        const auto middle = (v[0] + v[1] + v[2]) / 3.0F;
        renderer::Ray<float> r;
        r.origin = random.point(600).to<float>();
        r.direction = normalize(middle - r.origin);
        renderer::Hit<float> hit;
        CHECK(tree_agrees(scene, r, {}, &hit));
        if (!hit) continue;
        ++hits;
        const Vec3d o = r.origin.to<double>();
        const Vec3d d = r.direction.to<double>();
        const auto n = cross((v[1] - v[0]).to<double>(), (v[2] - v[0]).to<double>());
        const double condition = length(n) * length(d) / std::fabs(dot(n, d));
        const auto t =
            oracle::exact_plane_t(o, d, v[0].to<double>(), v[1].to<double>(), v[2].to<double>());
        const double error = std::fabs((math::DoubleDouble(double{hit.t}) - t).hi / t.hi);
        worst = std::max(worst, error / (8 * 0x1p-24 * condition));
        const auto s = surface_at(scene, r, hit);
        const auto& box = scene.geometry.tree.bounds;
        for (std::size_t k = 0; k < 3; ++k) {
            const float pad = 4 * 0x1p-24F * (std::fabs(box.lo[k]) + std::fabs(box.hi[k]));
            outside += s.position[k] >= box.lo[k] - pad && s.position[k] <= box.hi[k] + pad ? 0 : 1;
        }
    }
    CHECK(hits > 100);
    CHECK(worst <= 1);
    CHECK(outside == 0);
}

TEST_CASE("row 9: a triangle near by is not hit far away, however grazing the ray") {
    // embree#387: t = 12291 was reported for a triangle less than 600 away.
    SceneMaker make;
    make.triangle({-300, 0, -300}, {300, 0, -300}, {0, 0, 300});
    const auto scene = renderer::prepare<float>(make.scene);
    Random random(387);
    int hits = 0;
    for (int i = 0; i < 100000; ++i) {
        const double slope = 0.0087 * std::ldexp(1.0, -static_cast<int>(random.below(30)));
        renderer::Ray<float> r;
        r.origin = {static_cast<float>(random.in(-100, 100)), static_cast<float>(slope * 100),
                    static_cast<float>(random.in(-400, 0))};
        r.direction = normalize(Vec3d{random.in(-1, 1), -slope, random.in(-1, 1)}).to<float>();
        renderer::Counters counters;
        const auto hit = closest_hit(scene, r, {}, counters);
        if (!hit) continue;
        ++hits;
        CHECK(hit.t < 900);
    }
    CHECK(hits > 10000);
}

TEST_CASE("row 10: triangles of 1e-15 to 1e-12 are found, in float") {
    Random random(10);
    for (int i = 0; i < 2000; ++i) {
        const double size = std::pow(10.0, random.in(-15, -12));
        SceneMaker make;
        const Vec3d a = random.point(size);
        make.triangle(a, a + random.direction() * size, a + random.direction() * size);
        const auto scene = renderer::prepare<float>(make.scene);
        REQUIRE(scene.notes.empty());
        const auto& v = scene.geometry.triangles[0].vertices;
        renderer::Ray<float> r;
        // From near by, and from a distance that the direction can still be aimed from.
        r.origin = (random.direction() * (size * random.in(2, 1000))).to<float>();
        r.direction = (v[0] + v[1] + v[2]) / 3.0F - r.origin;
        renderer::Hit<float> hit;
        const bool edge_on =
            std::fabs(dot(normalize(cross((v[1] - v[0]).to<double>(), (v[2] - v[0]).to<double>())),
                          normalize(r.direction.to<double>()))) < 1e-2;
        CHECK(tree_agrees(scene, r, {}, &hit));
        if (!edge_on) CHECK(std::fabs(hit.t - 1) < 1e-3F);
    }
}

TEST_CASE("row 11: triangles of 1e18 and 1e30 are found; what float can not hold is noted") {
    Random random(11);
    for (const double size : {1e18, 1e30}) {
        for (int i = 0; i < 1000; ++i) {
            SceneMaker make;
            const Vec3d a = random.point(size);
            make.triangle(a, a + random.direction() * size, a + random.direction() * size);
            const auto scene = renderer::prepare<float>(make.scene);
            REQUIRE(scene.notes.empty());
            const auto& v = scene.geometry.triangles[0].vertices;
            renderer::Ray<float> r;
            r.origin = scene.to_local(random.direction() * size * 3.0);
            r.direction =
                normalize(((v[0] + v[1] + v[2]) / 3.0F - r.origin).to<double>()).to<float>();
            const bool edge_on =
                std::fabs(
                    dot(normalize(cross((v[1] - v[0]).to<double>(), (v[2] - v[0]).to<double>())),
                        r.direction.to<double>())) < 1e-2;
            renderer::Hit<float> hit;
            CHECK(tree_agrees(scene, r, {}, &hit));
            if (!edge_on) CHECK(hit);
        }
    }
    SceneMaker make;
    make.triangle({0, 0, 0}, {1e38, 0, 0}, {0, 1e38, 0});
    const auto scene = renderer::prepare<float>(make.scene);
    REQUIRE(scene.notes.size() == 1);
    CHECK(scene.notes[0].kind == renderer::PreparationNote::Kind::kOutOfRange);
    CHECK(renderer::prepare<double>(make.scene).notes.empty());
}

}  // namespace cobble::test
