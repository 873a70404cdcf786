// SPDX-License-Identifier: MIT
// Lights and surfaces a few roundings from where a shadow ray starts: row 15 of the hard cases.
#include <doctest/doctest.h>

#include "tests/hard/cores.hpp"
#include "tests/hard/height.hpp"
#include "tests/hard/wrong_shapes.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

/// Where `p`, close to the surface, is brought onto it and moved out by the first step that lifts
/// it above: a step is the spacing of T at the size of the largest coordinate.
template <typename T>
Vec3<T> one_ulp_above(const Surface<T>& surface, Vec3<T> p, Vec3<T> normal) {
    p = p - normal * static_cast<T>(height(surface, p));
    std::size_t axis = 0;
    T largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (std::fabs(normal[i]) > std::fabs(normal[axis])) axis = i;
        largest = std::max(largest, std::fabs(p[i]));
    }
    const T ulp = std::nextafter(largest, std::numeric_limits<T>::infinity()) - largest;
    const T step = normal[axis] > 0 ? ulp : -ulp;
    for (int i = 0; i < 8 && height(surface, p) > 0; ++i) p[axis] -= step;
    for (int i = 0; i < 16 && !(height(surface, p) > 0); ++i) p[axis] += step;
    REQUIRE(height(surface, p) > 0);
    return p;
}

/// Flat shapes, each twice in one place where `tilted_twins` or where they follow the axes: a light
/// above must be seen past the twin, too. On tilted ones a light a step above may lie on the far
/// side of the hit, which is as far off as its bound says, and of its rounded normal: from there
/// only the surface itself can be left out, not another in its place.
std::vector<ir::Scene> flat_scenes(double size, Vec3d at, bool tilted_twins) {
    std::vector<ir::Scene> scenes;
    const auto keep = [&](bool level, const auto& add) {
        SceneMaker make;
        add(make);
        if (level || tilted_twins) add(make);
        make.scene.camera.center = at;
        scenes.push_back(make.scene);
    };
    const Vec3d tilted = normalize(Vec3d{0.2, 1, 0.4});
    const Solid floor{{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 0, -1}},
                      {{0, 3, 4}, {4, 3, 2}, {4, 2, 1}}};
    keep(true, [&](SceneMaker& m) { m.plane({0, 1, 0}, at.y); });
    keep(false, [&](SceneMaker& m) { m.plane(tilted, dot(tilted, at)); });
    keep(false, [&](SceneMaker& m) {
        m.triangle(at + Vec3d{-1, -0.3, -1} * size, at + Vec3d{0.2, 0.4, 1} * size,
                   at + Vec3d{1, 0.2, -0.7} * size);
    });
    keep(true, [&](SceneMaker& m) { m.mesh(transformed(floor, size, at)); });
    keep(true, [&](SceneMaker& m) {
        const Vec3d half = Vec3d{1, 0.5, 1} * size;
        m.box(at - half, at + half);
    });
    return scenes;
}

struct Seen {
    int hits = 0;
    int hidden = 0;  ///< lights that are not seen
};

/// Lights a step above one flat surface, by a way to leave toward them. All cores are asked.
template <typename T, typename LeaveToward>
Seen lights_above(const ir::Scene& source, double size, Vec3d at, int shots, LeaveToward toward) {
    Questions<T> cores(source);
    const auto& scene = cores.reference;
    renderer::Counters counters;
    Random random(15);
    Seen result;
    for (int i = 0; i < shots; ++i) {
        renderer::Ray<T> r;
        r.origin = scene.to_local(at + random.point(3 * size) + Vec3d{0, 5, 0} * size);
        r.direction = normalize(scene.to_local(at + random.point(0.3 * size)) - r.origin);
        const auto hit = closest_hit(scene, r, {}, counters);
        if (!hit) continue;
        ++result.hits;
        const auto s = surface_at(scene, r, hit);
        const auto surface = surface_of(scene, hit.object, hit.face);
        // Right above, and above another place of the same flat surface.
        auto beside = s.position + (random.point(0.1 * size)).template to<T>();
        for (const auto p : {s.position, i % 2 == 0 ? beside : s.position}) {
            const auto light = one_ulp_above(surface, p, s.geometric_normal);
            const auto to_light = toward(s, light, T(0));
            result.hidden += cores.ask(to_light.ray, to_light.exclude) ? 1 : 0;
        }
    }
    CHECK(cores.differences() == "");
    return result;
}

template <typename T>
void check_planar(int shots) {
    std::int64_t hits = 0;
    std::int64_t hidden = 0;
    for (const double size : {1e-8, 1e-3, 1.0, 1e8}) {
        for (const Vec3d at : {Vec3d{}, Vec3d{0.3, 0.7, -0.2} * size, Vec3d{30, -7, 11} * size}) {
            for (const ir::Scene& scene : flat_scenes(size, at, false)) {
                CAPTURE(size);
                CAPTURE(at.x);
                CAPTURE(static_cast<int>(scene.objects[0].kind));
                const Seen seen =
                    lights_above<T>(scene, size, at, shots, renderer::leave_toward<T>);
                CHECK(seen.hits > shots / 20);
                CHECK(seen.hidden == 0);
                hits += seen.hits;
                hidden += seen.hidden;
            }
        }
    }
    record(15,
           counted(hidden) + " of " + counted(2 * hits) + " lights hidden, " + name_of_type<T>());
}

template <typename T>
void check_two_bounds(int shots) {
    for (const double size : {1e-8, 1e-3, 1.0, 1e8}) {
        for (const Vec3d at : {Vec3d{}, Vec3d{30, -7, 11} * size}) {
            CAPTURE(size);
            CAPTURE(at.x);
            auto scenes = flat_scenes(size, at, true);
            for (const bool placed : {false, true}) {
                SceneMaker make;
                for (int twin = 0; twin < 2; ++twin) {
                    make.sphere(placed ? Vec3d{} : at, placed ? 1 : size);
                    if (!placed) continue;
                    make.place_last({translation(at) * rotation({0.6, 0, 0.8}, 1) *
                                     scaling(Vec3d{1, -0.5, 2} * size)});
                }
                scenes.push_back(make.scene);
            }
            for (std::size_t which = 0; which < scenes.size(); ++which) {
                CAPTURE(which);
                const auto scene = renderer::prepare<T>(scenes[which]);
                renderer::Counters counters;
                Random random(152);
                int compared = 0;
                int hidden = 0;
                for (int i = 0; i < shots; ++i) {
                    renderer::Ray<T> r;
                    r.origin = scene.to_local(at + random.direction() * (5 * size));
                    r.direction =
                        normalize(scene.to_local(at + random.point(0.4 * size)) - r.origin);
                    const auto hit = closest_hit(scene, r, {}, counters);
                    if (!hit) continue;
                    const auto s = surface_at(scene, r, hit);
                    const auto surface = surface_of(scene, hit.object, hit.face);
                    // From the side that it is seen from.
                    const T out = dot(s.geometric_normal, r.direction) < 0 ? T(1) : T(-1);
                    const T away = out * s.error * static_cast<T>(random.in(2, 4));
                    const auto light = s.position + s.geometric_normal * away;
                    const double above = double{out} * height(surface, light);
                    if (!(above >= 2 * double{s.error})) continue;
                    ++compared;
                    const auto to_light = leave_toward(s, light, T(0));
                    hidden += any_hit(scene, to_light.ray, to_light.exclude, counters) ? 1 : 0;
                }
                CHECK(compared > shots / 40);
                CHECK(hidden == 0);
            }
        }
    }
}

/// Lights that are seen past a plane 5 bounds above the one that is left.
template <typename LeaveToward>
int leaks_through_gap(LeaveToward toward) {
    SceneMaker make;
    make.plane({0, 1, 0}, 0.7);
    const auto alone = renderer::prepare<float>(make.scene);
    renderer::Counters counters;
    Random random(154);
    int leaks = 0;
    for (int i = 0; i < 2000; ++i) {
        renderer::Ray<float> r;
        r.origin = alone.to_local(random.point(3) + Vec3d{0, 5, 0});
        r.direction = normalize(Vec3d{random.in(-1, 1), -1, random.in(-1, 1)}).to<float>();
        const auto s = surface_at(alone, r, closest_hit(alone, r, {}, counters));
        SceneMaker both;
        both.plane({0, 1, 0}, 0.7);
        both.plane({0, 1, 0}, 0.7 + 5 * double{s.error});
        const auto scene = renderer::prepare<float>(both.scene);
        REQUIRE(scene.origin == alone.origin);
        const auto light = s.position + (random.point(1) + Vec3d{0, 2, 0}).to<float>();
        const auto to_light = toward(s, light, 0.0F);
        leaks += any_hit(scene, to_light.ray, to_light.exclude, counters) ? 0 : 1;
    }
    return leaks;
}

}  // namespace

TEST_CASE("row 15: a light one ulp above a flat surface is seen from it") {
    check_planar<float>(200);
    check_planar<double>(40);
}

TEST_CASE("row 15: an absolute distance hides lights, or the things that should hide them") {
    int hidden = 0;
    for (const double size : {1e-8, 1.0, 1e8}) {
        for (const ir::Scene& scene : flat_scenes(size, Vec3d{0.3, 0.7, -0.2} * size, false)) {
            hidden += lights_above<float>(scene, size, Vec3d{0.3, 0.7, -0.2} * size, 50,
                                          leave_toward_by_epsilon<float>)
                          .hidden;
        }
    }
    CHECK(hidden > 0);
    CHECK(leaks_through_gap(leave_toward_by_epsilon<float>) > 0);
}

TEST_CASE(
    "row 15: a light is seen from any surface from 2 bounds above it, though it is there twice") {
    check_two_bounds<float>(400);
    check_two_bounds<double>(60);
}

TEST_CASE("row 15: a light behind another surface 4 bounds above is not seen") {
    // The converse: what lets the nearest lights be seen lets nothing through.
    CHECK(leaks_through_gap(renderer::leave_toward<float>) == 0);
    record(15, "0 of 2,000 rays through a surface 5 bounds above");
}

TEST_CASE("row 15: a sphere 4e-5 inside another never sees out, and is seen from between") {
    SceneMaker make;
    const auto inner = make.sphere({0, 0, 0}, 1);
    const auto outer = make.sphere({0, 0, 0}, 1 + 4e-5);
    const auto scene = renderer::prepare<float>(make.scene);
    renderer::Counters counters;
    Random random(1871);
    int leaks = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d n = random.direction();
        // A camera in the gap, looking in.
        renderer::Ray<float> r;
        r.origin = scene.to_local(n * (1 + 2e-5));
        r.direction = scene.to_local(random.point(0.4)) - r.origin;
        const auto hit = closest_hit(scene, r, {}, counters);
        CHECK(hit.object == inner);
        const auto s = surface_at(scene, r, hit);
        auto light = (random.direction() * 10).to<float>();
        if (dot(light, s.geometric_normal) < 0) light = -light;
        const auto to_light = leave_toward(s, light, 0.0F);
        if (!any_hit(scene, to_light.ray, to_light.exclude, counters)) ++leaks;
    }
    CHECK(leaks == 0);
    CHECK(outer.valid());
}

}  // namespace cobble::test
