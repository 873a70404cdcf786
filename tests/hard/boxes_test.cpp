// SPDX-License-Identifier: MIT
// Slabs, ties and degenerate shapes: rows 4, 5, 7, 8, 16 and 42 of the hard cases.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "renderer/geometry/bounds.hpp"
#include "renderer/geometry/triangle.hpp"
#include "tests/hard/aims.hpp"
#include "tests/hard/cores.hpp"
#include "tests/hard/wrong_shapes.hpp"
#include "tests/support/record.hpp"

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

struct AlongAxes {
    int hits = 0;
    int wrong = 0;  ///< that `cast` answers unlike brute force, or far from where it is
};

/// Rays along the axes, in slab planes and on edges, with zeros of both signs and numbers that are
/// almost zeros in the direction.
template <typename T, typename Cast>
AlongAxes along_axes(int count, Cast cast) {
    const ir::Scene scene = lattice();
    Questions<T> cores(scene);
    const auto& prepared = cores.reference;
    Random random(4);
    AlongAxes result;
    // The last: its inverse is finite, and infinite once it is widened.
    const T edge = std::numeric_limits<T>::min() / 4 + std::numeric_limits<T>::denorm_min();
    const T tiny[] = {0,
                      T(-0.0),
                      std::numeric_limits<T>::denorm_min(),
                      -std::numeric_limits<T>::denorm_min(),
                      std::numeric_limits<T>::min(),
                      edge,
                      -edge};
    for (int i = 0; i < count; ++i) {
        renderer::Ray<T> r;
        for (std::size_t k = 0; k < 3; ++k) {
            // On a slab plane, in the middle, or somewhere.
            const auto kind = random.below(3);
            const double at = kind == 0   ? double(random.below(4))
                              : kind == 1 ? random.below(4) + 0.5
                                          : random.in(-1, 4);
            r.origin[k] = static_cast<T>(at) - static_cast<T>(prepared.origin[k]);
            r.direction[k] = tiny[random.below(std::size(tiny))];
        }
        const std::size_t axis = random.below(3);
        const bool up = random.below(2) == 0;
        r.direction[axis] = up ? T(1) : T(-1);
        if (random.below(2) == 0) {
            r.origin[axis] = static_cast<T>((up ? -2.0 : 5.0) - prepared.origin[axis]);
        }
        const auto right = cores.ask(r);
        const renderer::Hit<T> hit = cast(prepared, r);
        if (!same(hit, right)) ++result.wrong;
        if (!hit) continue;
        ++result.hits;
        if (!(hit.t > 0 && hit.t < 10)) ++result.wrong;
        const auto s = surface_at(prepared, r, hit);
        for (std::size_t k = 0; k < 3; ++k) {
            const T end = r.origin[k] + r.direction[k] * hit.t;
            if (!(std::fabs(s.position[k] - end) < T(1e-5))) ++result.wrong;
        }
    }
    CHECK(cores.differences() == "");
    return result;
}

}  // namespace

TEST_CASE("rows 4 and 5: rays along box edges and in slab planes, with zeros of either sign") {
    const AlongAxes f = along_axes<float>(10000, kByTree);
    const AlongAxes d = along_axes<double>(10000, kByTree);
    CHECK(f.wrong == 0);
    CHECK(d.wrong == 0);
    CHECK(f.hits > 5000);
    CHECK(d.hits > 5000);
    for (const int row : {4, 5}) {
        record(row, counted(f.wrong + d.wrong) + " of 20,000 rays unlike brute force");
    }
}

TEST_CASE("rows 4 and 5: slabs that multiply 0 by infinity are found by the same rays") {
    Kernels naive;
    CHECK(along_axes<float>(1000, naive).wrong == 0);
    naive.box = nan_slabs;
    CHECK(along_axes<float>(1000, naive).wrong > 0);
}

TEST_CASE_TEMPLATE("row 23: a box is met exactly where its own slab test passes", T, float,
                   double) {
    // At a corner the ends cross by a rounding, and whether the slack bridges it depends on what it
    // is multiplied into.
    const auto same = [](const renderer::RaySlabs<T>& ray, const renderer::BoxBounds<T>& box) {
        return renderer::intersect_box(ray, box).has_value() ==
               !renderer::slab_span(ray, box).empty();
    };
    // Found by a hundred million rays at the corners of blocks: in float the slab test refuses it.
    const renderer::RaySlabs<T> found({T(0x1.2cfda6p+1), T(0x1.0a6ae6p+1), T(0x1.99c2e6p+1)},
                                      {T(-0x1.59fbcp+0), T(0x1.eb2a5cp+0), T(0x1.cc7adcp+0)});
    CHECK(same(found, {{0, 3, 4}, {1, 4, 5}}));
    Random random(23);
    int different = 0;
    for (int i = 0; i < 300000; ++i) {
        const Vec3d corner{double(random.below(9)), double(random.below(9)),
                           double(random.below(9))};
        const auto from = random.point(9).to<T>();
        const auto way = (corner - from.template to<double>()).template to<T>();
        const auto low = corner.to<T>();
        const renderer::RaySlabs<T> slabs(from, way);
        if (!same(slabs, {low, low + math::Vec3<T>{1, 1, 1}})) ++different;
    }
    CHECK(different == 0);
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

/// The least (t, object) of single triangles: what a hit is, without anything of the search; or
/// what is wrong, without t being held to the triangle's box.
template <typename T>
renderer::Hit<T> least_of_all(const renderer::PreparedScene<T>& scene, const renderer::Ray<T>& r,
                              bool clamped = true) {
    const renderer::RayShear<T> shear(r.origin, r.direction);
    const renderer::RaySlabs<T> slabs(r.origin, r.direction);
    renderer::Hit<T> least;
    for (const auto& triangle : scene.geometry.triangles) {
        const auto hit = renderer::intersect_triangle(shear, triangle.vertices);
        const auto span = renderer::slab_span(slabs, renderer::bounds_of(triangle.vertices));
        if (!hit || span.empty()) continue;
        const T t = clamped ? std::min(std::max(hit->t, span.near), span.far) : hit->t;
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
        Questions<T> cores(make.scene);
        const auto& scene = cores.reference;
        int missed = 0;
        int not_least = 0;
        int unclamped_differs = 0;
        for (int i = 0; i < rays; ++i) {
            // At vertices, T-vertices among them, at edges that others end on, and at both
            // anywhere.
            const Vec3d target = on_cut_floor(tilted, static_cast<std::uint32_t>(i), random);
            auto r = ray<T>(random.point(2) + Vec3d{4, 9, 4}, {});
            // Of any length: where t is not 1 its rounding and the slabs' differ, and only the
            // clamp keeps a triangle from being left out behind its equal.
            r.direction = (scene.to_local(target) - r.origin) * static_cast<T>(random.in(0.1, 1));
            if (i % 8 == 0) cores.ask(r);
            const auto hit = kByTree(scene, r);
            if (!hit) ++missed;
            if (i % 4 != 0) continue;
            if (!same(hit, least_of_all(scene, r))) ++not_least;
            if (!same(hit, least_of_all(scene, r, false))) ++unclamped_differs;
        }
        CHECK(missed == 0);
        CHECK(cores.differences() == "");
        CHECK(not_least == 0);
        record(7, counted(missed) + " of " + counted(rays) + " rays lost, " + counted(not_least) +
                      " given to another than the least, " + name_of_type<T>() +
                      (tilted ? ", tilted" : ""));
        // The rays are such that what is wrong shows.
        CHECK(unclamped_differs > 0);
    }
}

}  // namespace

TEST_CASE("row 7: T-vertices and duplicate coplanar triangles are hit; the least id wins, float") {
    check_cut_floor<float>(20000);
}

TEST_CASE("row 7: T-vertices and duplicate coplanar triangles are hit; the least id wins, double") {
    check_cut_floor<double>(4000);
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
    Questions<float> cores(make.scene);
    const auto& scene = cores.reference;
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
        const auto from = scene.to_local(random.direction() * 12);
        renderer::Ray<float> r;
        r.origin = from;
        r.direction = scene.to_local(random.point(1)) - from;
        const auto hit = cores.ask(r);
        others += hit && hit.object != good ? 1 : 0;
    }
    CHECK(cores.differences() == "");
    CHECK(others == 0);
    record(8, "10 of 10 noted, hit by " + counted(others) + " of 2,000 rays");
}

namespace {

/// Of rays from `height` above a box's face and a plane beside it, 8 ulp of t apart, how many find
/// the wrong one first.
template <typename Cast>
int wrong_order(double height, bool above, int count, Cast cast) {
    const double gap = 8 * height * 0x1p-23;
    SceneMaker make;
    const auto box = make.box({-1, 0, -1}, {1, 1, 1});
    const auto plane = make.plane({0, 1, 0}, above ? 1 + gap : 1 - gap);
    Questions<float> cores(make.scene);
    const auto& scene = cores.reference;
    Random random(16);
    int wrong = 0;
    for (int i = 0; i < count; ++i) {
        renderer::Ray<float> r;
        r.origin = scene.to_local({random.in(-5, 5), 1 + height, random.in(-5, 5)});
        r.direction =
            normalize(scene.to_local({random.in(-0.9, 0.9), 1, random.in(-0.9, 0.9)}) - r.origin);
        cores.ask(r);
        wrong += cast(scene, r).object == (above ? plane : box) ? 0 : 1;
    }
    CHECK(cores.differences() == "");
    return wrong;
}

}  // namespace

TEST_CASE("row 16: a plane next to a box's face is told apart beyond 8 ulp of t") {
    Kernels rough;
    rough.box = rough_reciprocal;
    for (const double height : {3.0, 30.0, 3000.0}) {
        CAPTURE(height);
        for (const bool above : {false, true})
            CHECK(wrong_order(height, above, 1000, kByTree) == 0);
        record(16, "0 of 2,000 in the wrong order from " + brief(height) + " above");
        // An approximate reciprocal errs to one side.
        CHECK(wrong_order(height, true, 500, rough) + wrong_order(height, false, 500, rough) > 0);
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
        record(42, counted(count) + " things: " + counted(deepest) + " levels of " +
                       counted(renderer::kMaxTreeDepth) + " allowed");
        CHECK(nodes.size() < count);
        if (!one_place) continue;
        const auto from = scene.to_local({0.2, 0.2, 5});
        const auto hit =
            closest_hit(scene, ray<float>(from.to<double>(), {0, 0, -1}), {}, counters);
        CHECK(hit.face == 0);
    }
}

}  // namespace cobble::test
