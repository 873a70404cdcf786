// SPDX-License-Identifier: MIT
// No ray slips between two triangles: rows 1, 2, 3, 12 and 22 of the hard cases.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
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
        // The one primitive that the tie rule names, every so often.
        if (i % 50 == 0 && !tree_agrees(scene, r)) ++missed;
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

TEST_CASE("row 2: no ray through a point of an edge is lost, and the tie rule names one face") {
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

namespace {

/// The edges between a face that looks at `from` and one that does not, narrowed as the mesh is.
std::vector<std::array<Vec3d, 2>> silhouette(const Solid& solid, Vec3d from) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    const auto at = [&](std::uint32_t i) { return solid.positions[i].to<float>().to<double>(); };
    for (const auto& f : solid.faces) {
        const auto n =
            oracle::exact_cross(oracle::minus(oracle::exact(at(f[1])), oracle::exact(at(f[0]))),
                                oracle::minus(oracle::exact(at(f[2])), oracle::exact(at(f[0]))));
        const auto to = oracle::minus(oracle::exact(from), oracle::exact(at(f[0])));
        const int side = oracle::exact_dot(n, to).sign();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = f[k];
            const auto j = f[(k + 1) % 3];
            // A face seen edge-on borders on whatever its neighbour is.
            sides[{std::min(i, j), std::max(i, j)}] += side == 0 ? 1 : 2 * side;
        }
    }
    std::vector<std::array<Vec3d, 2>> edges;
    for (const auto& [edge, sum] : sides) {
        if (sum > -4 && sum < 4) edges.push_back({at(edge.first), at(edge.second)});
    }
    return edges;
}

double distance_to(const std::array<Vec3d, 2>& segment, Vec3d o, Vec3d d) {
    const auto across = [&](Vec3d a) { return a - d * (dot(a, d) / dot(d, d)); };
    const Vec3d w = across(segment[0] - o);
    const Vec3d e = across(segment[1] - segment[0]);
    const double m = -dot(w, e) / dot(e, e);
    return length(w + e * (m > 0 ? (m < 1 ? m : 1) : 0));
}

}  // namespace

TEST_CASE("row 1: from outside the answer is the exact one beyond 8u of the silhouette") {
    Random random(9);
    renderer::Counters counters;
    for (const Solid& solid : {icosphere(1), random_star(1, 5), square_prism()}) {
        SceneMaker make;
        make.mesh(solid);
        const auto scene = renderer::prepare<float>(make.scene);
        REQUIRE(scene.origin == Vec3d{});
        int compared = 0;
        int past = 0;
        int wrong = 0;
        for (int i = 0; i < 1500; ++i) {
            renderer::Ray<float> r;
            r.origin = (random.direction() * 5).to<float>();
            // At vertices and edges, and past them by down to a rounding.
            const Vec3d aim =
                on_edge(solid, random, i % 2 == 0) +
                random.point(1) * std::ldexp(1.0, -static_cast<int>(random.below(28)));
            r.direction = aim.to<float>() - r.origin;
            const Vec3d o = r.origin.to<double>();
            const Vec3d d = r.direction.to<double>();
            double nearest = std::numeric_limits<double>::infinity();
            for (const auto& edge : silhouette(solid, o)) {
                nearest = std::min(nearest, distance_to(edge, o, d));
            }
            // Coordinates are at most 5 and 1.7 in size.
            if (!(nearest > 8 * 0x1p-24 * (5 + 1.7))) continue;
            ++compared;
            bool crossed = false;
            for (const auto& f : solid.faces) {
                int above = 0;
                int below = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    const Vec3d a = solid.positions[f[k]].to<float>().to<double>();
                    const Vec3d b = solid.positions[f[(k + 1) % 3]].to<float>().to<double>();
                    const int side = oracle::exact_side(o, d, a, b).sign();
                    above += side > 0 ? 1 : 0;
                    below += side < 0 ? 1 : 0;
                }
                crossed = crossed || (above == 0) != (below == 0);
            }
            past += crossed ? 0 : 1;
            wrong += bool(closest_hit(scene, r, {}, counters)) == crossed ? 0 : 1;
        }
        CHECK(compared > 500);
        CHECK(past > 20);
        CHECK(wrong == 0);
    }
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
