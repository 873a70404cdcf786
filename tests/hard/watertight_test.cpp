// SPDX-License-Identifier: MIT
// No ray slips between two triangles: rows 1, 2, 3, 12 and 22 of the hard cases.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "tests/hard/aims.hpp"
#include "tests/hard/cores.hpp"
#include "tests/hard/wrong_shapes.hpp"
#include "tests/oracle/exact.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

/// The solid around `center` with `scale`; a speck at the world's origin keeps the coordinates from
/// being rebased where `far` is asked for.
ir::Scene solid_scene(const Solid& solid, Vec3d center, bool far) {
    SceneMaker make;
    make.mesh(solid);
    if (far) {
        make.triangle({0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0});
        make.triangle(-center, -center + Vec3d{1e-3, 0, 0}, -center + Vec3d{0, 1e-3, 0});
    }
    return make.scene;
}

/// Rays from inside the solid that hit nothing, of `count` aimed at vertices or edges, by `cast`.
/// Now and then all cores are asked which one face the tie rule names.
template <typename T, typename Cast>
int leaks_of(Cast cast, const Solid& unit_solid, double scale, Vec3d center, bool vertices,
             bool far, int count) {
    const Solid solid = transformed(unit_solid, scale, center);
    const ir::Scene source = solid_scene(solid, center, far);
    Questions<T> cores(source);
    const auto& scene = cores.reference;
    if (far) REQUIRE(scene.origin == Vec3d{});
    Random random(42);
    int missed = 0;
    for (int i = 0; i < count; ++i) {
        // The faces of every solid here are farther than 0.1 from its centre.
        const Vec3d from = center + random.point(i % 4 == 0 ? 0 : 0.05) * scale;
        renderer::Ray<T> r;
        r.origin = scene.to_local(from);
        r.direction = scene.to_local(on_edge(solid, random, vertices)) - r.origin;
        if (i % 50 == 0) cores.ask(r);
        if (!cast(scene, r)) ++missed;
    }
    CHECK(cores.differences() == "");
    return missed;
}

template <typename T>
int leaks(const Solid& solid, double scale, Vec3d center, bool vertices, bool far, int count) {
    return leaks_of<T>(kByTree, solid, scale, center, vertices, far, count);
}

/// What a wrong test of triangles loses.
int leaks_by(bool (*kernel)(const renderer::RayShear<float>&, const Triangle&), double scale,
             Vec3d center, bool vertices, int count) {
    Kernels kernels;
    kernels.triangle = kernel;
    int missed = 0;
    for (const Solid& solid : {icosphere(1), random_star(1, 5)}) {
        missed += leaks_of<float>(kernels, solid, scale, center, vertices, center.x != 0, count);
    }
    return missed;
}

const Vec3d kFar{148376, 1234, -223423};

}  // namespace

TEST_CASE("rows 1 and 2: the rays at vertices and at edges find kernels that leak") {
    for (const bool vertices : {true, false}) {
        CAPTURE(vertices);
        // At a vertex so many triangles meet that some contracted one has it.
        if (!vertices) CHECK(leaks_by(contracted_edges, 1, {}, vertices, 10000) > 0);
        CHECK(leaks_by(moller_trumbore, 1, {}, vertices, 10000) > 0);
        CHECK(leaks_by(sound, 1, {}, vertices, 2000) == 0);
    }
}

TEST_CASE("row 3: the rays far from the origin, and at large and small things, find them too") {
    for (const bool vertices : {true, false}) {
        CAPTURE(vertices);
        CHECK(leaks_by(moller_trumbore, 100, kFar, vertices, 5000) > 0);
        CHECK(leaks_by(moller_trumbore, 1e6, {}, vertices, 5000) > 0);
        CHECK(leaks_by(moller_trumbore, 1e-6, {}, vertices, 5000) > 0);
        CHECK(leaks_by(moller_trumbore, 1e15, {}, vertices, 2000) > 1000);
        CHECK(leaks_by(absolute_epsilon, 1e-3, {}, vertices, 2000) > 1000);
        CHECK(leaks_by(sound, 1e-3, {}, vertices, 2000) == 0);
        CHECK(leaks_by(sound, 100, kFar, vertices, 2000) == 0);
    }
}

namespace {

/// None is lost of `count` in float and a tenth of that in double.
void check_no_leaks(int row, bool vertices, int count) {
    std::int64_t narrow = 0;
    std::int64_t wide = 0;
    for (const Solid& solid : closed_solids()) {
        narrow += leaks<float>(solid, 1, {}, vertices, false, count);
        wide += leaks<double>(solid, 1, {}, vertices, false, count / 10);
    }
    CHECK(narrow == 0);
    CHECK(wide == 0);
    record(row, counted(narrow) + " of " + counted(5 * count) + " rays lost, float");
    record(row, counted(wide) + " of " + counted(count / 2) + " rays lost, double");
}

}  // namespace

TEST_CASE("row 1: no ray through a vertex of a closed mesh is lost") {
    check_no_leaks(1, true, 60000);
}

TEST_CASE("row 2: no ray through a point of an edge is lost, and the tie rule names one face") {
    check_no_leaks(2, false, 60000);
}

TEST_CASE("row 3: nor far from the origin, very large or very small") {
    std::int64_t lost = 0;
    std::int64_t rays = 0;
    const auto shoot = [&](auto zero, const Solid& solid, double scale, Vec3d center, bool vertices,
                           bool far, int count) {
        const int missed = leaks<decltype(zero)>(solid, scale, center, vertices, far, count);
        CHECK(missed == 0);
        lost += missed;
        rays += count;
    };
    for (const Solid& solid : closed_solids()) {
        for (const bool vertices : {false, true}) {
            shoot(0.0F, solid, 1, kFar, vertices, false, 10000);
            // Without rebasing a float is some 2^-6 wide there: a solid of 100 remains one.
            shoot(0.0F, solid, 100, kFar, vertices, true, 10000);
            shoot(0.0, solid, 1, kFar, vertices, true, 2000);
            for (const double scale : {1e6, 1e-6, 1e15, 1e-15, 1e-25}) {
                shoot(0.0F, solid, scale, {}, vertices, false, 5000);
                shoot(0.0, solid, scale, {}, vertices, false, 500);
            }
        }
    }
    record(3, counted(lost) + " of " + counted(rays) + " rays lost");
}

namespace {

/// The edges between a face that looks at `from` and one that does not, narrowed as the mesh is.
std::vector<std::array<Vec3d, 2>> silhouette(const Solid& solid, Vec3d from) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    const auto at = [&](std::uint32_t i) { return solid.positions[i].to<float>().to<double>(); };
    for (const auto& f : solid.faces) {
        // The normal, (b - a) x (c - a), along the way to the eye.
        const int side = oracle::side_sign(at(f[0]), from - at(f[0]), at(f[1]), at(f[2]));
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

namespace {

struct Outside {
    int compared = 0;
    int past = 0;   ///< that miss the solid
    int wrong = 0;  ///< hit or miss told wrongly, farther than 8u of the size from the outline
};

/// Rays from outside at vertices and edges, and past them by down to a rounding, by `cast`.
template <typename Cast>
Outside from_outside(const Solid& solid, int count, Cast cast) {
    SceneMaker make;
    make.mesh(solid);
    Questions<float> cores(make.scene);
    const auto& scene = cores.reference;
    REQUIRE(scene.origin == Vec3d{});
    Random random(9);
    Outside result;
    for (int i = 0; i < count; ++i) {
        renderer::Ray<float> r;
        r.origin = (random.direction() * 5).to<float>();
        const Vec3d aim = on_edge(solid, random, i % 2 == 0) +
                          random.point(1) * std::ldexp(1.0, -static_cast<int>(random.below(28)));
        r.direction = aim.to<float>() - r.origin;
        if (i % 4 < 2) cores.ask(r);
        const Vec3d o = r.origin.to<double>();
        const Vec3d d = r.direction.to<double>();
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& edge : silhouette(solid, o)) {
            nearest = std::min(nearest, distance_to(edge, o, d));
        }
        // Coordinates are at most 5 and 1.7 in size.
        if (!(nearest > 8 * 0x1p-24 * (5 + 1.7))) continue;
        ++result.compared;
        bool crossed = false;
        for (const auto& f : solid.faces) {
            int above = 0;
            int below = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3d a = solid.positions[f[k]].to<float>().to<double>();
                const Vec3d b = solid.positions[f[(k + 1) % 3]].to<float>().to<double>();
                const int side = oracle::side_sign(o, d, a, b);
                above += side > 0 ? 1 : 0;
                below += side < 0 ? 1 : 0;
            }
            crossed = crossed || (above == 0) != (below == 0);
        }
        result.past += crossed ? 0 : 1;
        result.wrong += bool(cast(scene, r)) == crossed ? 0 : 1;
    }
    CHECK(cores.differences() == "");
    return result;
}

}  // namespace

TEST_CASE("row 1: from outside the answer is the exact one beyond 8u of the silhouette") {
    int found = 0;
    int compared = 0;
    for (const Solid& solid : {icosphere(1), random_star(1, 5), square_prism()}) {
        const Outside right = from_outside(solid, 700, kByTree);
        CHECK(right.compared > 250);
        CHECK(right.past > 10);
        CHECK(right.wrong == 0);
        compared += right.compared;
        found += from_outside(solid, 300, [](const auto& scene, const auto& r) {
                     const renderer::RayShear<float> shear(r.origin, r.direction);
                     bool hit = false;
                     for (const auto& t : scene.geometry.triangles) {
                         hit = hit || generous_edges(shear, t.vertices);
                     }
                     return hit;
                 }).wrong;
    }
    CHECK(found > 0);
    record(1, "0 of " + counted(compared) + " wrong from outside");
}

namespace {

struct NearEdges {
    int compared = 0;
    int wrong = 0;  ///< beyond 8u of the size
    int lost = 0;   ///< of lines that truly meet the triangle, however near to an edge
};

/// Lines that pass an edge at a few roundings' distance or so, by a test of one triangle.
template <typename Kernel>
NearEdges near_edges(Kernel accepts, int count) {
    Random random(12);
    NearEdges result;
    for (int i = 0; i < count; ++i) {
        const auto o = random.point(4).to<float>();
        const Triangle v{random.point(1).to<float>(), random.point(1).to<float>(),
                         random.point(1).to<float>()};
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
        const bool met = accepts(renderer::RayShear<float>(o, d), v);
        if (inside && !met) ++result.lost;
        if (!sure) continue;
        ++result.compared;
        if (met != inside) ++result.wrong;
    }
    return result;
}

}  // namespace

TEST_CASE("row 12: the answer is the exact one wherever the line keeps a margin from the edges") {
    const NearEdges right = near_edges(sound, 15000);
    CHECK(right.compared > 8000);
    CHECK(right.wrong == 0);
    CHECK(right.lost == 0);
    record(12, counted(right.wrong) + " of " + counted(right.compared) + " wrong, " +
                   counted(right.lost) + " lost");
    CHECK(near_edges(contracted_edges, 10000).lost > 0);
    CHECK(near_edges(moller_trumbore, 10000).lost > 0);
}

TEST_CASE("row 12: every core gives one answer to lines at a few roundings from an edge") {
    // Triangles beside each other in blocks, so that lanes hold different ones; all rays at one of
    // them from one eye, so that packets form.
    Random random(423);
    for (int scene = 0; scene < 20; ++scene) {
        SceneMaker make;
        for (int i = 0; i < 24; ++i) {
            make.triangle(random.point(1), random.point(1), random.point(1));
        }
        Questions<float> narrow(make.scene);
        Questions<double> wide(make.scene);
        const Vec3d eye = random.point(4);
        for (int i = 0; i < 128; ++i) {
            const auto& v = make.scene.triangles[random.below(24)].keys[0];
            const Vec3d at = lerp(v[0], v[1], random.unit()) +
                             random.point(1) * std::ldexp(1.0, -static_cast<int>(random.below(40)));
            narrow.ask(ray<float>(eye - narrow.reference.origin, at - eye));
            if (i % 4 == 0) wide.ask(ray<double>(eye - wide.reference.origin, at - eye));
        }
        CHECK(narrow.differences() == "");
        CHECK(wide.differences() == "");
    }
}

namespace {

struct Parity {
    int odd = 0;
    int crossings = 0;
};

/// Lines through the solid, half of them in planes of symmetry: edge-on, through edges and
/// vertices. `crossings_of` gives the distances of a line's crossings in order.
template <typename T, typename CrossingsOf>
Parity parity(const Solid& solid, int count, CrossingsOf crossings_of) {
    SceneMaker make;
    make.mesh(solid);
    Questions<T> cores(make.scene);
    Random random(22);
    Parity result;
    for (int i = 0; i < count; ++i) {
        renderer::Ray<T> r;
        r.origin = {T(random.below(3)) - 1, T(random.below(3)) - 1, T(5)};
        if (random.below(2) == 0) r.origin = (random.direction() * 5).to<T>();
        const Vec3d at = on_edge(solid, random, random.below(2) == 0);
        r.direction = at.to<T>() - r.origin;
        if (random.below(8) == 0) r.direction = {0, 0, T(-1)};
        if (i % 8 == 0) cores.ask(r);
        const std::vector<T> t = crossings_of(cores.reference, r);
        result.odd += static_cast<int>(t.size() % 2);
        result.crossings += static_cast<int>(t.size());
        CHECK(std::is_sorted(t.begin(), t.end()));
    }
    CHECK(cores.differences() == "");
    return result;
}

/// By the half-open rule.
template <typename T>
std::vector<T> enumerated(const renderer::PreparedScene<T>& scene, const renderer::Ray<T>& r) {
    std::vector<T> all;
    for (const auto& hit : renderer::enumerate_hits(scene, r)) all.push_back(hit.t);
    return all;
}

/// With edges that belong to both their triangles.
std::vector<float> inclusive(const renderer::PreparedScene<float>& scene,
                             const renderer::Ray<float>& r) {
    std::vector<float> all;
    const renderer::RayShear<float> shear(r.origin, r.direction);
    for (const auto& triangle : scene.geometry.triangles) {
        const auto hit = renderer::intersect_triangle(shear, triangle.vertices);
        if (hit && hit->t > 0) all.push_back(hit->t);
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

TEST_CASE("row 22: a closed mesh is entered as often as it is left") {
    std::int64_t crossings = 0;
    for (const Solid& solid : closed_solids()) {
        const Parity f = parity<float>(solid, 4000, enumerated<float>);
        const Parity d = parity<double>(solid, 400, enumerated<double>);
        CHECK(f.odd == 0);
        CHECK(d.odd == 0);
        CHECK(f.crossings + d.crossings > 4400);
        crossings += f.crossings + d.crossings;
        CHECK(parity<float>(solid, 400, inclusive).odd > 0);
    }
    record(22, "0 of 22,000 lines with an odd count, " + counted(crossings) + " crossings");
}

}  // namespace cobble::test
