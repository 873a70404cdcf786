// SPDX-License-Identifier: MIT
// No ray slips between two triangles: rows 1, 2, 3, 12 and 22 of the hard cases.
#include <doctest/doctest.h>

#include <vector>

#include "tests/hard/scenes.hpp"
#include "tests/hard/wrong_kernels.hpp"
#include "tests/oracle/exact.hpp"

namespace cobble::test {

namespace {

std::vector<Solid> closed_solids() {
    return {icosphere(2), icosphere(0), square_prism(), random_star(1, 5), random_star(2, 6)};
}

/// A point of an edge, or a vertex, of the solid.
Vec3d on_edge(const Solid& solid, Random& random, bool vertex) {
    const auto& f = solid.faces[random.below(static_cast<std::uint32_t>(solid.faces.size()))];
    const Vec3d a = solid.positions[f[0]];
    const Vec3d b = solid.positions[f[1]];
    return vertex ? a : lerp(a, b, random.unit());
}

/// Rays from inside the solid that hit nothing, of `count` aimed at vertices or edges. The
/// solid is around `center` with `scale`; a speck at the world's origin keeps the coordinates from
/// being rebased where `far` is asked for.
template <typename T>
int leaks(const Solid& unit_solid, double scale, Vec3d center, bool vertices, bool far, int count) {
    SceneMaker make;
    const Solid solid = transformed(unit_solid, scale, center);
    make.mesh(solid);
    if (far) {
        make.triangle({0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0});
        make.triangle(-center, -center + Vec3d{1e-3, 0, 0}, -center + Vec3d{0, 1e-3, 0});
    }
    const auto scene = renderer::prepare<T>(make.scene);
    if (far) REQUIRE(scene.origin == Vec3d{});
    Random random(42);
    int missed = 0;
    renderer::Counters counters;
    for (int i = 0; i < count; ++i) {
        // The faces of every solid here are farther than 0.1 from its centre.
        const Vec3d from = center + random.point(i % 4 == 0 ? 0 : 0.05) * scale;
        renderer::Ray<T> r;
        r.origin = scene.to_local(from);
        r.direction = scene.to_local(on_edge(solid, random, vertices)) - r.origin;
        if (!closest_hit(scene, r, {}, counters)) ++missed;
    }
    return missed;
}

/// What a kernel misses of the same rays, testing every face.
template <typename Kernel>
int kernel_leaks(Kernel kernel, double scale, int count) {
    Random random(43);
    int missed = 0;
    for (const Solid& unit_solid : {icosphere(1), random_star(1, 5)}) {
        const Solid solid = transformed(unit_solid, scale, {});
        for (int i = 0; i < count; ++i) {
            const Vec3d from = random.point(i % 4 == 0 ? 0 : 0.05) * scale;
            const auto o = from.to<float>();
            const auto d = on_edge(solid, random, i % 2 == 0).to<float>() - o;
            const renderer::RayShear<float> shear(o, d);
            bool hit = false;
            for (const auto& f : solid.faces) {
                // Only what lies ahead: the mesh is all around.
                const Vec3d middle =
                    (solid.positions[f[0]] + solid.positions[f[1]]) + solid.positions[f[2]];
                if (dot(middle, d.to<double>()) < 0) continue;
                hit = hit || kernel(shear, Triangle{solid.positions[f[0]].to<float>(),
                                                    solid.positions[f[1]].to<float>(),
                                                    solid.positions[f[2]].to<float>()});
            }
            if (!hit) ++missed;
        }
    }
    return missed;
}

}  // namespace

TEST_CASE("the aimed rays find kernels that leak") {
    CHECK(kernel_leaks(contracted_edges, 1, 20000) > 0);
    CHECK(kernel_leaks(moller_trumbore, 1, 20000) > 0);
    CHECK(kernel_leaks(absolute_epsilon, 1e-3, 2000) > 1000);
    CHECK(kernel_leaks(sound, 1, 20000) == 0);
    CHECK(kernel_leaks(sound, 1e-3, 2000) == 0);
}

TEST_CASE("row 1: no ray through a vertex of a closed mesh is lost") {
    for (const Solid& solid : closed_solids()) {
        CHECK(leaks<float>(solid, 1, {}, true, false, 200000) == 0);
        CHECK(leaks<double>(solid, 1, {}, true, false, 10000) == 0);
    }
}

TEST_CASE("row 2: no ray through a point of an edge is lost") {
    for (const Solid& solid : closed_solids()) {
        CHECK(leaks<float>(solid, 1, {}, false, false, 200000) == 0);
        CHECK(leaks<double>(solid, 1, {}, false, false, 10000) == 0);
    }
}

TEST_CASE("row 3: nor far from the origin, very large or very small") {
    const Vec3d far{148376, 1234, -223423};
    for (const Solid& solid : closed_solids()) {
        for (const bool vertices : {false, true}) {
            CHECK(leaks<float>(solid, 1, far, vertices, false, 20000) == 0);
            // Without rebasing a float is some 2^-6 wide there: a solid of 100 remains one.
            CHECK(leaks<float>(solid, 100, far, vertices, true, 20000) == 0);
            CHECK(leaks<double>(solid, 1, far, vertices, true, 2000) == 0);
            for (const double scale : {1e6, 1e-6, 1e15, 1e-15, 1e-25}) {
                CHECK(leaks<float>(solid, scale, {}, vertices, false, 10000) == 0);
                CHECK(leaks<double>(solid, scale, {}, vertices, false, 1000) == 0);
            }
        }
    }
}

TEST_CASE("row 1: from outside a ray well inside the silhouette is not lost") {
    // The exact sides of the line against the two triangles of each edge tell whether it passes
    // through the solid at all; only lines with a margin count.
    const Solid solid = icosphere(1);
    SceneMaker make;
    make.mesh(solid);
    const auto scene = renderer::prepare<float>(make.scene);
    Random random(9);
    renderer::Counters counters;
    int through = 0;
    for (int i = 0; i < 4000; ++i) {
        renderer::Ray<float> r;
        r.origin = (random.direction() * 3).to<float>();
        r.direction = on_edge(solid, random, i % 2 == 0).to<float>() - r.origin;
        const Vec3d o = r.origin.to<double>();
        const Vec3d d = r.direction.to<double>();
        // Distance of the line to the centre below the inscribed sphere's radius, 0.9.
        const double margin = length(cross(o, normalize(d)));
        if (margin > 0.9) continue;
        ++through;
        CHECK(closest_hit(scene, r, {}, counters));
        int crossed = 0;
        for (const auto& f : solid.faces) {
            int same = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3d a = solid.positions[f[k]].to<float>().to<double>();
                const Vec3d b = solid.positions[f[(k + 1) % 3]].to<float>().to<double>();
                same += oracle::exact_side(o, d, a, b).sign();
            }
            crossed += same == 3 || same == -3 ? 1 : 0;
        }
        // The exact answer never has more strict crossings than an entry and an exit.
        CHECK(crossed <= 2);
    }
    CHECK(through > 1000);
}

TEST_CASE("row 12: the answer is the exact one wherever the line keeps a margin from the edges") {
    Random random(12);
    int compared = 0;
    int wrong = 0;
    int lost = 0;
    for (int i = 0; i < 60000; ++i) {
        const auto o = random.point(4).to<float>();
        const Triangle v{random.point(1).to<float>(), random.point(1).to<float>(),
                         random.point(1).to<float>()};
        // Near an edge, at a distance of a few roundings or so.
        const double f = random.unit();
        const Vec3d at = lerp(v[0].to<double>(), v[1].to<double>(), f) +
                         random.point(1) * std::ldexp(1.0, -static_cast<int>(random.below(26)));
        const auto d = (at - o.to<double>()).to<float>();
        bool inside = true;
        bool sure = true;
        int sense = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3d a = v[k].to<double>();
            const Vec3d b = v[(k + 1) % 3].to<double>();
            const auto side = oracle::exact_side(o.to<double>(), d.to<double>(), a, b);
            // Distance of the line from the edge's line, times both lengths.
            const double value = side.near().hi;
            const double margin =
                8 * 0x1p-24 * (length(o.to<double>()) + 2) * length(cross(d.to<double>(), b - a));
            sure = sure && std::fabs(value) > margin;
            if (sense == 0) sense = side.sign();
            inside = inside && side.sign() == sense;
        }
        // A line that truly meets it is never lost, however near to an edge.
        if (inside && !sound(renderer::RayShear<float>(o, d), v)) ++lost;
        if (!sure) continue;
        ++compared;
        if (sound(renderer::RayShear<float>(o, d), v) != inside) ++wrong;
    }
    CHECK(compared > 20000);
    CHECK(wrong == 0);
    CHECK(lost == 0);
}

TEST_CASE("row 22: a closed mesh is entered as often as it is left") {
    Random random(22);
    for (const Solid& solid : closed_solids()) {
        SceneMaker make;
        make.mesh(solid);
        const auto f = renderer::prepare<float>(make.scene);
        const auto d = renderer::prepare<double>(make.scene);
        int odd = 0;
        int crossings = 0;
        const auto count = [&](const auto& scene, auto zero) {
            using T = decltype(zero);
            renderer::Ray<T> r;
            // Half of the lines lie in planes of symmetry: edge-on, through edges and vertices.
            r.origin = {T(random.below(3)) - 1, T(random.below(3)) - 1, T(5)};
            if (random.below(2) == 0) r.origin = (random.direction() * 5).to<T>();
            const Vec3d at = on_edge(solid, random, random.below(2) == 0);
            r.direction = at.to<T>() - r.origin;
            if (random.below(8) == 0) r.direction = {0, 0, T(-1)};
            const auto hits = renderer::enumerate_hits(scene, r);
            odd += static_cast<int>(hits.size() % 2);
            crossings += static_cast<int>(hits.size());
            for (std::size_t k = 1; k < hits.size(); ++k) CHECK(hits[k - 1].t <= hits[k].t);
        };
        for (int i = 0; i < 4000; ++i) count(f, 0.0F);
        for (int i = 0; i < 400; ++i) count(d, 0.0);
        CHECK(odd == 0);
        CHECK(crossings > 4400);
    }
}

}  // namespace cobble::test
