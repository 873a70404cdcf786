// SPDX-License-Identifier: MIT
// Slabs, ties and degenerate shapes: rows 4, 5, 7, 8, 16 and 42 of the hard cases.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "renderer/geometry/bounds.hpp"
#include "renderer/geometry/triangle.hpp"
#include "tests/hard/scenes.hpp"

namespace cobble::test {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Unit boxes of a 3x3x3 lattice, every second one, and the flat faces of the rest as triangles.
ir::Scene lattice() {
    SceneMaker make;
    for (int i = 0; i < 27; ++i) {
        const Vec3d at{double(i % 3), double(i / 3 % 3), double(i / 9)};
        if (i % 2 == 0) {
            make.box(at, at + Vec3d{1, 1, 1});
        } else {
            make.mesh(transformed(square_prism(), 0.5, at + Vec3d{0.5, 0.5, 0.5}));
        }
    }
    return make.scene;
}

template <typename T>
void along_axes() {
    const ir::Scene scene = lattice();
    const auto prepared = renderer::prepare<T>(scene);
    Random random(4);
    int hits = 0;
    int wrong = 0;
    const T tiny[] = {0, T(-0.0), std::numeric_limits<T>::denorm_min(),
                      -std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::min()};
    for (int i = 0; i < 20000; ++i) {
        renderer::Ray<T> r;
        for (std::size_t k = 0; k < 3; ++k) {
            // On a slab plane, in the middle, or somewhere.
            const auto kind = random.below(3);
            const double at = kind == 0   ? double(random.below(4))
                              : kind == 1 ? random.below(4) + 0.5
                                          : random.in(-1, 4);
            r.origin[k] = static_cast<T>(at) - static_cast<T>(prepared.origin[k]);
            r.direction[k] = tiny[random.below(5)];
        }
        const std::size_t axis = random.below(3);
        const bool up = random.below(2) == 0;
        r.direction[axis] = up ? T(1) : T(-1);
        if (random.below(2) == 0) {
            r.origin[axis] = static_cast<T>((up ? -2.0 : 5.0) - prepared.origin[axis]);
        }
        renderer::Hit<T> hit;
        if (!tree_agrees(prepared, r, {}, &hit)) ++wrong;
        if (!hit) continue;
        ++hits;
        if (!(hit.t > 0 && hit.t < 10)) ++wrong;
        const auto s = surface_at(prepared, r, hit);
        for (std::size_t k = 0; k < 3; ++k) {
            const T end = r.origin[k] + r.direction[k] * hit.t;
            if (!(std::fabs(s.position[k] - end) < T(1e-5))) ++wrong;
        }
    }
    CHECK(wrong == 0);
    CHECK(hits > 10000);
}

}  // namespace

TEST_CASE("rows 4 and 5: rays along box edges and in slab planes, with zeros of either sign") {
    along_axes<float>();
    along_axes<double>();
}

TEST_CASE("row 5: an origin on a slab plane, and a direction along it, is inside the slab") {
    SceneMaker make;
    const auto box = make.box({0, 0, 0}, {1, 1, 1});
    const auto scene = renderer::prepare<float>(make.scene);
    renderer::Counters counters;
    for (const double zero : {0.0, -0.0}) {
        for (const double y : {0.0, 1.0}) {
            const auto r = ray<float>({-2, y, 0.5}, {1, zero, zero});
            const auto hit = closest_hit(scene, r, {}, counters);
            CHECK(hit.object == box);
            CHECK(hit.t == 2);
            CHECK(hit.face == 0);
        }
        const float above = std::nextafter(1.0F, 2.0F);
        CHECK(!closest_hit(scene, ray<float>({-2, above, 0.5}, {1, zero, 0}), {}, counters));
    }
}

namespace {

/// A floor of 8 by 8 cells cut in three ways, so that edges end in the middle of others, each
/// triangle twice, wound either way, in the order of a shuffle.
std::vector<std::array<Vec3d, 3>> cut_floor(bool tilted, Random& random) {
    std::vector<std::array<Vec3d, 3>> all;
    const auto at = [&](double x, double y) {
        return tilted ? Vec3d{x, 0.25 * x + 0.5 * y, y} : Vec3d{x, 0.0, y};
    };
    for (int i = 0; i < 64; ++i) {
        const double x = i % 8;
        const double y = i / 8;
        const Vec3d a = at(x, y);
        const Vec3d b = at(x + 1, y);
        const Vec3d c = at(x + 1, y + 1);
        const Vec3d d = at(x, y + 1);
        const Vec3d m = at(x + 0.5, y + 0.5);
        if (i % 3 == 0) {
            all.insert(all.end(), {{a, b, m}, {b, c, m}, {c, d, m}, {d, a, m}});
        } else {
            const Vec3d e = at(x + 0.5, y);  // on the neighbour's edge
            all.insert(all.end(), {{a, e, d}, {e, b, c}, {e, c, d}});
        }
    }
    const auto count = all.size();
    for (std::size_t i = 0; i < count; ++i) all.push_back({all[i][0], all[i][2], all[i][1]});
    for (std::size_t i = all.size(); i > 1; --i) {
        std::swap(all[i - 1], all[random.below(static_cast<std::uint32_t>(i))]);
    }
    return all;
}

/// The least (t, object) of single triangles: what a hit is, without anything of the search.
template <typename T>
renderer::Hit<T> least_of_all(const renderer::PreparedScene<T>& scene, const renderer::Ray<T>& r) {
    const renderer::RayShear<T> shear(r.origin, r.direction);
    const renderer::RaySlabs<T> slabs(r.origin, r.direction);
    renderer::Hit<T> least;
    for (const auto& triangle : scene.geometry.triangles) {
        const auto hit = renderer::intersect_triangle(shear, triangle.vertices);
        const auto span = renderer::slab_span(slabs, renderer::bounds_of(triangle.vertices));
        if (!hit || span.empty()) continue;
        const T t = std::min(std::max(hit->t, span.near), span.far);
        if (!(t > 0)) continue;
        if (!least || t < least.t || (t == least.t && triangle.object < least.object)) {
            least = {t, triangle.object, 0, hit->u, hit->v};
        }
    }
    return least;
}

template <typename T>
void check_cut_floor(int rays) {
    for (const bool tilted : {false, true}) {
        SceneMaker make;
        Random random(7);
        for (const auto& t : cut_floor(tilted, random)) make.triangle(t[0], t[1], t[2]);
        const auto scene = renderer::prepare<T>(make.scene);
        int missed = 0;
        int differ = 0;
        int not_least = 0;
        for (int i = 0; i < rays; ++i) {
            // At vertices, T-vertices among them, at edges that others end on, and at both
            // anywhere.
            const double x = 0.5 * (1 + random.below(15));
            const double y = i % 2 == 0 ? random.in(0.1, 7.9) : 0.5 * (1 + random.below(15));
            const bool across = i % 4 == 0;
            const Vec3d on{across ? y : x, 0, across ? x : y};
            const Vec3d target = on + Vec3d{0, tilted ? 0.25 * on.x + 0.5 * on.z : 0, 0};
            auto r = ray<T>(random.point(2) + Vec3d{4, 9, 4}, {});
            // Of any length: where t is not 1 its rounding and the slabs' differ, and only the
            // clamp keeps a triangle from being left out behind its equal.
            r.direction = (scene.to_local(target) - r.origin) * static_cast<T>(random.in(0.1, 1));
            renderer::Hit<T> hit;
            if (!tree_agrees(scene, r, {}, &hit)) ++differ;
            if (!hit) ++missed;
            if (!same(hit, least_of_all(scene, r))) ++not_least;
        }
        CHECK(missed == 0);
        CHECK(differ == 0);
        CHECK(not_least == 0);
    }
}

}  // namespace

TEST_CASE("row 7: T-vertices and duplicate coplanar triangles are hit; the least id wins, float") {
    check_cut_floor<float>(40000);
}

TEST_CASE("row 7: T-vertices and duplicate coplanar triangles are hit; the least id wins, double") {
    check_cut_floor<double>(8000);
}

TEST_CASE("row 8: what has no area or no number is never hit, is in no box, and is noted") {
    SceneMaker make;
    make.triangle({0, 0, 0}, {0, 0, 0}, {1, 0, 0});
    make.triangle({0, 0, 0}, {1, 1, 1}, {3, 3, 3});
    make.triangle({5, 5, 5}, {5, 5, 5}, {5, 5, 5});
    make.triangle({kNan, 0, 0}, {1, 0, 0}, {0, 1, 0});
    make.triangle({0, 0, 0}, {kInfinity, 0, 0}, {0, 1, 0});
    make.sphere({9, 0, 0}, 0);
    make.sphere({9, 0, 0}, -1);
    make.sphere({9, kNan, 0}, 1);
    make.box({-9, -9, -9}, {-9, -9, -8});
    // Distinct in double, one point once narrowed.
    make.triangle({1, 1, 1}, {1, 1 + 1e-12, 1}, {1 + 1e-12, 1, 1});
    const auto good = make.triangle({0, 0, -1}, {1, 0, -1}, {0, 1, -1});
    const auto scene = renderer::prepare<float>(make.scene);
    using Kind = renderer::PreparationNote::Kind;
    const Kind expected[] = {Kind::kDegenerate, Kind::kDegenerate, Kind::kDegenerate,
                             Kind::kOutOfRange, Kind::kOutOfRange, Kind::kDegenerate,
                             Kind::kDegenerate, Kind::kOutOfRange, Kind::kDegenerate,
                             Kind::kFlattened};
    REQUIRE(scene.notes.size() == 10);
    for (std::uint32_t i = 0; i < 10; ++i) {
        CHECK(scene.notes[i].object.value == i);
        CHECK(scene.notes[i].kind == expected[i]);
    }
    const auto& b = scene.geometry.tree.bounds;
    CHECK(scene.to_world(b.lo) == Vec3d{0, 0, -1});
    CHECK(scene.to_world(b.hi) == Vec3d{1, 1, -1});
    Random random(8);
    int others = 0;
    for (int i = 0; i < 2000; ++i) {
        renderer::Hit<float> hit;
        const auto from = scene.to_local(random.direction() * 12);
        renderer::Ray<float> r;
        r.origin = from;
        r.direction = scene.to_local(random.point(1)) - from;
        CHECK(tree_agrees(scene, r, {}, &hit));
        others += hit && hit.object != good ? 1 : 0;
    }
    CHECK(others == 0);
}

TEST_CASE("row 16: a plane next to a box's face is told apart beyond 8 ulp of t") {
    for (const double height : {3.0, 30.0, 3000.0}) {
        const double gap = 8 * height * 0x1p-23;
        for (const bool above : {false, true}) {
            SceneMaker make;
            const auto box = make.box({-1, 0, -1}, {1, 1, 1});
            const auto plane = make.plane({0, 1, 0}, above ? 1 + gap : 1 - gap);
            const auto scene = renderer::prepare<float>(make.scene);
            Random random(16);
            for (int i = 0; i < 2000; ++i) {
                renderer::Ray<float> r;
                r.origin = scene.to_local({random.in(-5, 5), 1 + height, random.in(-5, 5)});
                r.direction = normalize(
                    scene.to_local({random.in(-0.9, 0.9), 1, random.in(-0.9, 0.9)}) - r.origin);
                renderer::Hit<float> hit;
                CHECK(tree_agrees(scene, r, {}, &hit));
                CHECK(hit.object == (above ? plane : box));
            }
        }
    }
}

TEST_CASE("row 42: trees over nothing, one thing, and a million things in one place") {
    renderer::Counters counters;
    {
        SceneMaker make;
        const auto scene = renderer::prepare<float>(make.scene);
        CHECK(scene.geometry.tree.nodes.empty());
        CHECK(!closest_hit(scene, ray<float>({}, {1, 0, 0}), {}, counters));
        CHECK(!any_hit(scene, ray<float>({}, {0, 0, 1}), {}, counters));
    }
    {
        SceneMaker make;
        const auto only = make.sphere({3, 0, 0}, 1);
        const auto scene = renderer::prepare<float>(make.scene);
        CHECK(closest_hit(scene, ray<float>(-scene.origin, {1, 0, 0}), {}, counters).object ==
              only);
    }
    for (const bool one_place : {true, false}) {
        SceneMaker make;
        Solid heap;
        heap.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        // In one place; or ever nearer to a corner, which a heuristic would peel one by one.
        const std::uint32_t count = one_place ? 1000000 : 4000;
        for (std::uint32_t i = 0; i < count; ++i) {
            if (one_place) {
                heap.faces.push_back({0, 1, 2});
                continue;
            }
            const double s = std::ldexp(1.0, -static_cast<int>(i % 100));
            const auto base = static_cast<std::uint32_t>(heap.positions.size());
            for (const Vec3d p : {Vec3d{0, 0, 0}, Vec3d{s, 0, 0}, Vec3d{0, s, 0}}) {
                heap.positions.push_back(p + Vec3d{s, 0, s});
            }
            heap.faces.push_back({base, base + 1, base + 2});
        }
        make.mesh(heap);
        const auto scene = renderer::prepare<float>(make.scene);
        // Levels, by walking: children follow their parents.
        const auto& nodes = scene.geometry.tree.nodes;
        std::vector<std::uint32_t> level(nodes.size(), 1);
        std::uint32_t deepest = 0;
        std::size_t held = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            deepest = level[i] > deepest ? level[i] : deepest;
            for (std::size_t k = 0; k < 4; ++k) {
                const bool used = nodes[i].bounds[0][0][k] <= nodes[i].bounds[1][0][k];
                if (used && nodes[i].count[k] == 0) {
                    REQUIRE(nodes[i].first[k] > i);
                    level[nodes[i].first[k]] = level[i] + 1;
                }
                held += nodes[i].count[k];
            }
        }
        CHECK(held == count);
        CHECK(deepest < renderer::kMaxTreeDepth);
        CHECK(nodes.size() < count);
        if (!one_place) continue;
        const auto from = scene.to_local({0.2, 0.2, 5});
        const auto hit =
            closest_hit(scene, ray<float>(from.to<double>(), {0, 0, -1}), {}, counters);
        CHECK(hit.face == 0);
    }
}

}  // namespace cobble::test
