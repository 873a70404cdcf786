// SPDX-License-Identifier: MIT
// What lies close behind a surface: rows 13 and 14 of the hard cases.
#include <doctest/doctest.h>

#include <functional>
#include <optional>

#include "tests/hard/cores.hpp"
#include "tests/hard/height.hpp"
#include "tests/hard/wrong_shapes.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

/// Adds a shape once more `by` farther out along its normals.
using Layer = std::function<void(SceneMaker& make, double by, Vec3d normal)>;

struct Kind {
    const char* name;
    Layer add;
};

/// Numbers that float holds, so that the same shape stands in float's scene and in double's.
Vec3d in_float(Vec3d p) { return p.to<float>().to<double>(); }

std::vector<Kind> kinds(double size, Vec3d c) {
    const double radius = in_float({size, 0, 0}).x;
    const Vec3d p0 = in_float(c + Vec3d{-0.9, -0.8, 0.3} * size);
    const Vec3d p1 = in_float(c + Vec3d{1, -0.4, -0.6} * size);
    const Vec3d p2 = in_float(c + Vec3d{-0.2, 0.9, 0.1} * size);
    const Vec3d up = normalize(Vec3d{0.2, 1, 0.4});
    const Vec3d half = Vec3d{0.5, 0.7, 0.6} * size;
    return {
        {"sphere", [=](SceneMaker& m, double by, Vec3d) { m.sphere(c, radius + by); }},
        {"triangle", [=](SceneMaker& m, double by,
                         Vec3d n) { m.triangle(p0 + n * by, p1 + n * by, p2 + n * by); }},
        {"box",
         [=](SceneMaker& m, double by, Vec3d) {
             m.box(c - half - Vec3d{by, by, by}, c + half + Vec3d{by, by, by});
         }},
        {"plane", [=](SceneMaker& m, double by, Vec3d) { m.plane(up, dot(up, c) + by); }},
        {"mesh", [=](SceneMaker& m, double by,
                     Vec3d n) { m.mesh(transformed(random_star(1, 3), size, c + n * by)); }},
        {"instance",
         [=](SceneMaker& m, double by, Vec3d n) {
             m.mesh(random_star(1, 3));
             m.place_last({translation(c + n * by) * rotation({0.6, 0}, 1) *
                           scaling(Vec3d{1, -0.5, 2} * size)});
         }},
    };
}

struct Tally {
    int served = 0;   ///< hits with a second surface between 4 and 12 bounds behind
    int rays = 0;     ///< that left them toward it
    int missed = 0;   ///< it was not met, or only its far side
    int again = 0;    ///< the first surface was met once more, or its twin
    int rebased = 0;  ///< the second surface moved the coordinates' origin: no comparison
};

/// Shoots at two of a kind in one place, and leaves each hit toward two more, 4 to 7 bounds behind
/// it or before it. `leave` is how: see renderer::leave(). All cores are asked now and then.
template <typename T, typename Leave>
Tally leave_toward_second(const Kind& kind, Vec3d center, double size, int shots, int leaving,
                          Leave leave) {
    Tally tally;
    Random random(1313);
    renderer::Counters counters;
    SceneMaker first;
    for (int twin = 0; twin < 2; ++twin) kind.add(first, 0, {});
    const auto alone = renderer::prepare<T>(first.scene);
    for (int i = 0; i < shots; ++i) {
        renderer::Ray<T> r;
        r.origin = alone.to_local(center + random.direction() * (size * random.in(3, 20)));
        r.direction = normalize(alone.to_local(center + random.point(0.4 * size)) - r.origin);
        const auto hit = closest_hit(alone, r, {}, counters);
        if (!hit) continue;
        const auto s = surface_at(alone, r, hit);
        const Vec3d n = s.geometric_normal.template to<double>();
        const double bound{s.error};
        const double side = i % 2 == 0 ? 1 : -1;
        SceneMaker both;
        for (int twin = 0; twin < 2; ++twin) kind.add(both, 0, {});
        for (int twin = 0; twin < 2; ++twin) {
            kind.add(both, side * bound * (4 + 3 * random.unit()), n);
        }
        const auto scene = renderer::prepare<T>(both.scene);
        if (!(scene.origin == alone.origin)) {
            ++tally.rebased;
            continue;
        }
        // Which of the two is nearer, and whether both are far enough, is a matter of rounding.
        const double here = height(surface_of(scene, hit.object, hit.face), s.position);
        double gap[2];
        for (std::uint32_t k = 0; k < 2; ++k) {
            const auto other = surface_of(scene, ir::ObjectId{2 + k}, hit.face);
            gap[k] = side * (here - height(other, s.position));
        }
        if (!(gap[0] >= 4 * bound && gap[1] >= 4 * bound && gap[0] <= 12 * bound)) continue;
        // An edge of the second one may lie in the way.
        const auto rim = static_cast<T>(0.01);
        const bool flat = s.kind == ir::ShapeKind::kTriangle || s.kind == ir::ShapeKind::kMesh;
        if (flat && !(hit.u > rim && hit.v > rim && hit.u + hit.v < 1 - rim)) continue;
        if (s.kind == ir::ShapeKind::kBox) {
            bool inside = true;
            const auto& box = surface_of(alone, hit.object, hit.face).box;
            for (std::size_t k = 0; k < 3; ++k) {
                const T margin = static_cast<T>(size) * rim;
                inside = inside && (k == hit.face / 2 || (s.position[k] > box.lo[k] + margin &&
                                                          s.position[k] < box.hi[k] - margin));
            }
            if (!inside) continue;
        }
        ++tally.served;
        const bool by_all = tally.served % 32 == 1;
        std::optional<Questions<T>> cores;
        if (by_all) cores.emplace(both.scene);
        for (int k = 0; k < leaving; ++k) {
            Vec3d d = random.direction();
            if (dot(d, n) * side < 0) d = -d;
            const double cosine = std::fabs(dot(d, n));
            if (cosine < 0.1) continue;
            ++tally.rays;
            const auto next = leave(s, d.to<T>(), T(0));
            if (by_all && k < 50) cores->ask(next.ray, next.exclude);
            const auto second = closest_hit(scene, next.ray, next.exclude, counters);
            if (second && second.object.value < 2) ++tally.again;
            // Its near side: no farther along the normal than the gap and the bounds.
            const bool found =
                second && second.object.value >= 2 && double{second.t} * cosine <= 14 * bound;
            if (!found) ++tally.missed;
        }
        if (by_all) CHECK(cores->differences() == "");
    }
    return tally;
}

template <typename T>
void check_second(int shots, int leaving) {
    std::int64_t rays = 0;
    std::int64_t missed = 0;
    for (const double size : {1e-8, 1e-3, 1.0, 1e3, 1e8}) {
        CAPTURE(size);
        const Vec3d offsets[] = {{0, 0, 0}, {30 * size, -7 * size, 11 * size}};
        for (const Vec3d offset : offsets) {
            CAPTURE(offset.x);
            const Vec3d c = in_float(offset);
            for (const Kind& kind : kinds(size, c)) {
                CAPTURE(kind.name);
                const Tally t =
                    leave_toward_second<T>(kind, c, size, shots, leaving, renderer::leave<T>);
                // Far from zero double's world leaves no room for so small a gap.
                if (sizeof(T) == sizeof(float) || offset == Vec3d{}) CHECK(t.served >= 10);
                CHECK(t.missed == 0);
                CHECK(t.again == 0);
                rays += t.rays;
                missed += t.missed;
            }
        }
    }
    record(13, counted(missed) + " of " + counted(rays) + " rays miss what is 4 bounds behind, " +
                   name_of_type<T>());
}

}  // namespace

TEST_CASE("row 13: an absolute distance passes what lies behind a small surface") {
    for (const double size : {1e-8, 1e-3}) {
        for (const Kind& kind : kinds(size, {})) {
            CAPTURE(size);
            CAPTURE(kind.name);
            const Tally t =
                leave_toward_second<float>(kind, {}, size, 60, 20, leave_by_epsilon<float>);
            CHECK(t.missed > 0);
        }
    }
}

TEST_CASE("row 13: a second surface 4 bounds behind is found, float") {
    check_second<float>(60, 150);
}
TEST_CASE("row 13: a second surface 4 bounds behind is found, double") {
    check_second<double>(50, 40);
}

}  // namespace cobble::test
