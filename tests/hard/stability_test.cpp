// SPDX-License-Identifier: MIT
// What `cobble stability` measures: a scene that asks too much of float, and scenes that do not.
#include "renderer/stability/stability.hpp"

#include <doctest/doctest.h>

#include "ir/math/elementary.hpp"
#include "renderer/stability/aim.hpp"
#include "renderer/stability/exact.hpp"
#include "renderer/stability/mesh_edges.hpp"
#include "tests/hard/scenes.hpp"
#include "tests/hard/wrong_kernels.hpp"

namespace cobble::test {

namespace {

using renderer::AimPoints;
using renderer::measure_stability;
using renderer::ObjectStability;
using renderer::Stability;
using renderer::StabilityOptions;

/// One of everything, beside each other in front of the camera, sharing edges and faces.
SceneMaker gallery(double size, Vec3d at) {
    SceneMaker make;
    make.scene.camera.center = at + Vec3d{0.3, 1.1, 9} * size;
    make.sphere(at, size);
    make.box(at + Vec3d{1, -1, -1} * size, at + Vec3d{2, 1, 1} * size);
    make.box(at + Vec3d{2, -1, -1} * size, at + Vec3d{3, 0.3, 1} * size);  // a face in common
    make.triangle(at + Vec3d{-3, -1, 0} * size, at + Vec3d{-2, -1, 0} * size,
                  at + Vec3d{-2, 1, 0.2} * size);
    make.triangle(at + Vec3d{-3, -1, 0} * size, at + Vec3d{-2, 1, 0.2} * size,
                  at + Vec3d{-3, 1, 0.4} * size);  // an edge in common
    make.mesh(transformed(random_star(2, 7), size, at + Vec3d{0, 2.5, 0} * size));
    make.plane({0, 1, 0}, at.y - size);  // where the boxes end
    make.mesh(icosphere(2));
    make.place_last({translation(at + Vec3d{4, 0, -2} * size) * rotation({0.6, 0, 0.8}, 1) *
                     scaling(Vec3d{1, 0.5, 2} * size)});
    make.sphere({0, 0, 0}, 1);
    make.place_last({translation(at + Vec3d{-4, 0.5, -2} * size) * rotation({0, 0.6, 0.8}, 2) *
                     scaling(Vec3d{0.5, 1, 0.7} * size)});
    return make;
}

StabilityOptions rays(std::uint64_t count) {
    StabilityOptions options;
    options.rays = count;
    return options;
}

const ObjectStability& entry_of(const Stability& stability, ir::ObjectId id) {
    for (const auto& entry : stability.objects) {
        if (entry.object == id) return entry;
    }
    FAIL("no such object");
    return stability.objects.front();
}

/// A ball of triangles that the camera looks at, from a line of the scene's file.
ir::Scene ball() {
    SceneMaker make;
    make.mesh(icosphere(1));
    make.scene.camera.center = {0.3, 0.2, 4};
    return make.scene;
}

Solid with_face(Solid solid, Vec3d a, Vec3d b, Vec3d c) {
    const auto first = static_cast<std::uint32_t>(solid.positions.size());
    for (const Vec3d p : {a, b, c}) solid.positions.push_back(p);
    solid.faces.push_back({first, first + 1, first + 2});
    return solid;
}

/// With a face around zero: a mesh near the camera that reaches so far has a coarse grid.
Solid torn(Solid solid) { return with_face(std::move(solid), {0, 0, 0}, {1, 0, 0}, {0, 1, 0}); }

}  // namespace

TEST_CASE("stability: a kernel that leaks is found out by its cracks") {
    const ir::Scene scene = ball();
    auto options = rays(1000000);
    const auto measure = [&](auto kernel) {
        cast_with(options, [kernel](const auto& in, const auto& ray, const auto& exclude) {
            return cast_by(in, ray, exclude, kernel);
        });
        return measure_stability(scene, options);
    };
    const Stability good = measure(sound);
    CHECK(good.clean());
    CHECK(good.objects[0].hits > 5000);
    for (const Stability& bad : {measure(contracted_edges), measure(moller_trumbore)}) {
        CHECK(!bad.clean());
        const ObjectStability& entry = bad.objects[0];
        CHECK(entry.cracks > 0);
        CHECK(entry.changed == 0);
        // An example is where float saw through: on the ball's side that is seen.
        REQUIRE(entry.example);
        CHECK(entry.example->fault == renderer::StabilityFault::kCrack);
        CHECK(entry.example->position.z > -0.5);
        CHECK(length(entry.example->position) > 0.9);
        CHECK(entry.example->face < 80);
    }
}

TEST_CASE("stability: a kernel that sees what is not there is found out") {
    auto options = rays(100000);
    cast_with(options, [](const auto& in, const auto& ray, const auto& exclude) {
        auto hit = cast_by(in, ray, exclude, sound);
        // A thousandth too near: far more than rounding.
        hit.t *= 0.999F;
        return hit;
    });
    const Stability bad = measure_stability(ball(), options);
    CHECK(!bad.clean());
    CHECK(bad.objects[0].changed > 500);
    CHECK(bad.objects[0].cracks == 0);
    REQUIRE(bad.objects[0].example);
    CHECK(bad.objects[0].example->fault == renderer::StabilityFault::kChanged);
}

TEST_CASE("stability: a start that stays in its surface is found out by self-hits") {
    auto options = rays(100000);
    cast_with(options, [](const auto& in, const auto& ray, const auto& exclude) {
        if (!exclude.object.valid()) return cast_by(in, ray, exclude, sound);
        // The start is moved back to behind the surface that it left, and nothing is left out.
        auto from = ray;
        const float back = 2e-6F / length(ray.direction);
        from.origin = ray.origin - ray.direction * back;
        auto hit = cast_by(in, from, {}, sound);
        hit.t = hit.t > back ? hit.t - back : std::numeric_limits<float>::min();
        return hit;
    });
    const Stability bad = measure_stability(ball(), options);
    CHECK(!bad.clean());
    CHECK(bad.objects[0].self_hits > 500);
    REQUIRE(bad.objects[0].example);
    CHECK(bad.objects[0].example->fault == renderer::StabilityFault::kSelfHit);
}

TEST_CASE("stability: a scene within float's means has no fault and plenty of precision") {
    for (const double size : {1e-3, 1.0, 1e4}) {
        CAPTURE(size);
        const SceneMaker make = gallery(size, Vec3d{0.1, -0.2, 0.3} * size);
        const Stability stability = measure_stability(make.scene, rays(100000));
        CHECK(stability.clean());
        CHECK(stability.notes.empty());
        CHECK(stability.rays == 9 * 1001);
        REQUIRE(stability.objects.size() == 9);
        for (const ObjectStability& entry : stability.objects) {
            CAPTURE(entry.object.value);
            CHECK(entry.rays == 1001);
            CHECK(entry.hits > 100);
            CHECK(entry.faults() == 0);
            CHECK(!entry.example);
            CHECK(entry.least_ulps() > 1000);
        }
    }
}

TEST_CASE("stability: a planet's horizon is no self-hit") {
    // Mirror directions at a tangent are rounded to below the surface as often as above it.
    SceneMaker make;
    make.sphere({0, -1e8, 0}, 1e8);
    make.sphere({0, 1, 0}, 1);
    make.scene.camera.center = {0, 1, 5};
    const Stability stability = measure_stability(make.scene, rays(1000000));
    CHECK(stability.objects.front().self_hits == 0);
    CHECK(stability.clean());
}

TEST_CASE("stability: far from zero a scene keeps its precision, for it is brought near") {
    const SceneMaker make = gallery(1, {3e7, -2e7, 1e7});
    const Stability stability = measure_stability(make.scene, rays(100000));
    CHECK(stability.clean());
    CHECK(stability.objects.front().least_ulps() > 1000);
}

TEST_CASE("stability: a thing 1e7 away from another, near the camera, keeps its precision") {
    SceneMaker make;
    const Vec3d there{1e7, 0, 0};
    make.sphere({0, 0, 0}, 1);
    const auto ball = make.sphere(there, 10);
    make.triangle(there + Vec3d{20, 0, 0}, there + Vec3d{20.01, 0, 0}, there + Vec3d{20, 0.01, 0});
    make.plane({0, 1, 0}, -10);
    make.scene.camera.center = there + Vec3d{0, 0, 60};
    const Stability stability = measure_stability(make.scene, rays(10000));
    CHECK(stability.clean());
    CHECK(stability.notes.empty());
    CHECK(entry_of(stability, ball).least_ulps() > 100);
}

TEST_CASE("stability: tiny things 1e7 away from the camera leave no precision, and sort first") {
    SceneMaker make;
    // Coordinates are local to what is near the camera: a step of float is a whole there, and a
    // pixel seen through this lens is 0.08 wide.
    const Vec3d there{0, 0, -1e7};
    const auto ball = make.sphere(there, 10);
    const auto speck = make.triangle({1e7 + 20, 0, 0}, {1e7 + 20.01, 0, 0}, {1e7 + 20, 0.01, 0});
    make.scene.camera.angle = 4e-6;
    const Stability stability = measure_stability(make.scene, rays(10000));
    CHECK(entry_of(stability, ball).hits > 50);
    CHECK(entry_of(stability, ball).least_ulps() < 0.5);
    CHECK(entry_of(stability, ball).least_ulps() > 1e-3);
    CHECK(entry_of(stability, speck).hits == 0);
    CHECK(stability.objects[0].object == ball);
    REQUIRE(stability.notes.size() == 1);
    CHECK(stability.notes[0].object == speck);
    CHECK(stability.notes[0].kind == renderer::PreparationNote::Kind::kFlattened);
}

TEST_CASE("stability: what is too far away to be seen is not lost") {
    SceneMaker make;
    // A thread a million away, where a pixel is a thousand wide.
    const auto thread = make.triangle({1e6 + 0.3, 0, 0}, {1e6 + 0.301, 0, 0}, {1e6 + 0.3, 1, 0});
    make.sphere({0, 0, 0}, 1);
    make.scene.camera.center = {0, 0, 5};
    const Stability stability = measure_stability(make.scene, rays(20000));
    CHECK(stability.clean());
    CHECK(entry_of(stability, thread).hits == 0);
    CHECK(entry_of(stability, thread).lost == 0);
}

TEST_CASE("stability: a pixel narrower than a step of float is a fault") {
    SceneMaker make;
    const Vec3d there{1e7, 0, 0};
    const auto block = make.mesh(torn(transformed(square_prism(), 16, there)));
    make.scene.camera.center = there + Vec3d{0, 0, 60};
    const Stability coarse = measure_stability(make.scene, rays(10000));
    CHECK(!coarse.clean());
    const ObjectStability& entry = coarse.objects[0];
    CHECK(entry.object == block);
    CHECK(entry.faults() == 0);
    CHECK(entry.too_coarse());
    REQUIRE(entry.worst);
    CHECK(entry.worst->step == 0.5);
    CHECK(entry.worst->object == block);
    // Pixels wide enough, whatever float does to the scene: the same block from further away.
    make.scene.camera.center = there + Vec3d{0, 0, 6000};
    CHECK(measure_stability(make.scene, rays(10000)).clean());
}

TEST_CASE("stability: an object that float sees nothing of is lost if double sees it") {
    // Through a long lens, where a half is a step: the speck is one point there.
    const auto look = [](double distance, bool hidden) {
        SceneMaker make;
        const Vec3d along = Vec3d{1, 1, 1} * (1 / std::sqrt(3.0));
        const Vec3d there = Vec3d{std::floor(distance), std::floor(distance), std::floor(distance)};
        make.mesh(transformed(icosphere(1), 0.1, there + Vec3d{0.11, 0.11, 0.11}));
        make.sphere({-3, 0, 0}, 1);
        if (hidden) make.sphere(there - Vec3d{40, 40, 40}, 20);
        ir::Camera& camera = make.scene.camera;
        camera.center = {0, 0, 0};
        camera.forward = along;
        const Vec3d right = cross(along, Vec3d{0, 1, 0});
        camera.right = right * (1 / length(right));
        camera.up = cross(camera.right, along);
        camera.angle = 40 / distance;
        return measure_stability(make.scene, rays(20000));
    };
    const ir::ObjectId speck{0};
    const Stability lost = look(6e6, false);
    CHECK(!lost.clean());
    const ObjectStability& entry = entry_of(lost, speck);
    CHECK(entry.hits == 0);
    CHECK(entry.lost > 0);
    REQUIRE(entry.example);
    CHECK(entry.example->fault == renderer::StabilityFault::kLost);
    CHECK(length(entry.example->position - Vec3d{6e6, 6e6, 6e6}) < 0.5);
    // Hidden from double too: nothing is lost.
    CHECK(entry_of(look(6e6, true), speck).lost == 0);
    // Nor nearer by.
    const Stability good = look(600, false);
    CHECK(entry_of(good, speck).hits > 40);
    CHECK(entry_of(good, speck).lost == 0);
}

TEST_CASE("stability: faces that float flattens count as lost if they can be seen") {
    using Kind = renderer::PreparationNote::Kind;
    // A needle of no width to speak of.
    SceneMaker needle;
    needle.mesh(with_face(icosphere(1), {1, 2, 0}, {1, 3, 0}, {std::nextafter(1.0, 2.0), 2.5, 0}));
    needle.scene.camera.center = {0, 0, 9};
    const Stability fine = measure_stability(needle.scene, rays(10000));
    CHECK(fine.clean());
    REQUIRE(fine.notes.size() == 1);
    CHECK(fine.notes[0].kind == Kind::kFlattened);
    CHECK(fine.objects[0].faces == 81);
    CHECK(fine.objects[0].faces_lost == 0);
    // A crumb of a pixel or two where the steps of float are a half.
    SceneMaker crumb;
    const Vec3d there{1e7, 0, 0};
    crumb.mesh(torn(with_face(transformed(icosphere(1), 10, there), there + Vec3d{15.1, 0, 0},
                              there + Vec3d{15.2, 0, 0}, there + Vec3d{15.1, 0.1, 0})));
    crumb.scene.camera.center = there + Vec3d{0, 0, 40};
    const Stability part = measure_stability(crumb.scene, rays(10000));
    CHECK(!part.clean());
    CHECK(part.objects[0].faces_lost == 1);
    CHECK(part.objects[0].faces == 82);
    CHECK(part.objects[0].lost == 0);
}

TEST_CASE("stability: what float cannot hold is noted") {
    SceneMaker make;
    make.scene.camera.center = {0, 0, 10};
    // In double a wall; in float out of range.
    const auto wall = make.triangle({-1e37, -1e37, 0}, {1e37, -1e37, 0}, {0, 1e37, 0});
    make.sphere({0, 0, -5}, 1);
    const Stability stability = measure_stability(make.scene, rays(1000));
    CHECK(entry_of(stability, wall).hits == 0);
    CHECK(entry_of(stability, wall).lost > 0);
    REQUIRE(stability.notes.size() == 1);
    CHECK(stability.notes[0].kind == renderer::PreparationNote::Kind::kOutOfRange);
}

TEST_CASE("stability: the same twice, and rays are shared out to the last") {
    const SceneMaker make = gallery(1, {});
    const Stability a = measure_stability(make.scene, rays(7));
    const Stability b = measure_stability(make.scene, rays(7));
    CHECK(a.rays == 7);
    for (std::size_t i = 0; i < a.objects.size(); ++i) {
        CHECK(a.objects[i].object == b.objects[i].object);
        CHECK(a.objects[i].hits == b.objects[i].hits);
        CHECK(a.objects[i].rays <= 1);
    }
}

TEST_CASE("stability: rays are aimed at vertices, edges and outlines") {
    const Vec3d eye{0, 0, 9};
    SceneMaker make;
    const auto ball = make.sphere({1, 0, 0}, 2);
    const auto box = make.box({-1, -2, -3}, {1, 2, 3});
    const AimPoints on_ball(make.scene, ball, eye);
    const AimPoints on_box(make.scene, box, eye);
    double nearest_to_outline = 1;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const Vec3d n = (on_ball.point(i) - Vec3d{1, 0, 0}) / 2;
        CHECK(length(n) == doctest::Approx(1));
        if (i % 4 == 0 || i % 4 == 3) {
            const Vec3d to_eye = normalize(eye - on_ball.point(i));
            CHECK(dot(n, to_eye) > 0);
            nearest_to_outline = std::min(nearest_to_outline, dot(n, to_eye));
        }
        const Vec3d p = on_box.point(i);
        const int ends = (std::fabs(p.x) == 1 ? 1 : 0) + (std::fabs(p.y) == 2 ? 1 : 0) +
                         (std::fabs(p.z) == 3 ? 1 : 0);
        constexpr int kEnds[] = {3, 2, 1, 2};
        CHECK(ends == kEnds[i % 4]);
    }
    CHECK(nearest_to_outline < 1e-5);
}

TEST_CASE("stability: rays are aimed at the outline of a mesh") {
    const Vec3d eye{0.3, 0.2, 4};
    SceneMaker make;
    const auto ball = make.mesh(icosphere(3));
    const renderer::MeshEdges edges(make.scene.meshes[0]);
    CHECK(edges.closed());
    const AimPoints points(make.scene, ball, eye, &edges);
    int near_outline = 0;
    for (std::uint32_t i = 3; i < 403; i += 4) {
        // Of a sphere the outline is where the line of sight is at right angles to the radius;
        // edges of this one are 0.15 long.
        const Vec3d p = points.point(i);
        near_outline += std::fabs(dot(normalize(p), normalize(eye - p))) < 0.2 ? 1 : 0;
    }
    CHECK(near_outline >= 99);
}

TEST_CASE("stability: a mesh is closed if each edge has two faces") {
    SceneMaker make;
    make.mesh(icosphere(1));
    ir::Mesh mesh = make.scene.meshes[0];
    CHECK(renderer::MeshEdges(mesh).closed());
    const auto missing = mesh.faces.back();
    mesh.faces.pop_back();
    CHECK(!renderer::MeshEdges(mesh).closed());
    mesh.faces.push_back(missing);
    mesh.faces.push_back(missing);
    const renderer::MeshEdges doubled(mesh);
    CHECK(!doubled.closed());
    // Three faces at one edge: none of them is the other one's only neighbour.
    const auto last = static_cast<std::uint32_t>(mesh.faces.size() - 1);
    CHECK(doubled.across(last, 0) == renderer::MeshEdges::kNone);
}

TEST_CASE("stability: exact arithmetic tells hits from misses a rounding apart") {
    using renderer::Meeting;
    const std::array<Vec3d, 3> triangle{Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}};
    renderer::Ray<double> ray;
    ray.direction = {0, 0, -1};
    const auto at = [&](double x, double y) {
        ray.origin = {x, y, 0.75};
        return renderer::meet_exactly(ray, triangle);
    };
    CHECK(at(0.25, 0.25).meeting == Meeting::kMeets);
    CHECK(static_cast<double>(at(0.25, 0.25).t) == 0.75);
    CHECK(at(0.25, 1e-28).meeting == Meeting::kMeets);
    CHECK(at(0.25, -1e-28).meeting == Meeting::kMisses);
    CHECK(at(0.25, 0).meeting == Meeting::kUnsure);
    // On the slanted edge x + y = 1, which rounding of the sum would not tell from its neighbours.
    const double x = 1.0 / 3;
    CHECK(at(x, std::nextafter(1 - x, 0.0)).meeting == Meeting::kMeets);
    CHECK(at(x, std::nextafter(1 - x, 1.0)).meeting == Meeting::kMisses);
    ray.direction = {0, 0, 1};
    CHECK(at(0.25, 0.25).meeting == Meeting::kMisses);  // behind it
}

TEST_CASE("stability: exact arithmetic knows spheres, boxes and planes too") {
    using renderer::Meeting;
    renderer::Ray<double> ray;
    ray.direction = {0, 0, -2};
    const auto check = [&ray](double x, double z, const auto& shape, Meeting meeting, double t) {
        ray.origin = {x, 0.125, z};
        const auto found = renderer::meet_exactly(ray, shape);
        CHECK(found.meeting == meeting);
        if (meeting == Meeting::kMeets) CHECK(static_cast<double>(found.t) == t);
    };
    const renderer::SphereKey<double> sphere{{0, 0.125, 0}, 1};
    check(0, 3, sphere, Meeting::kMeets, 1);
    check(0, 0.5, sphere, Meeting::kMeets, 0.75);  // from inside
    check(0, -3, sphere, Meeting::kMisses, 0);     // behind it
    check(1, 3, sphere, Meeting::kUnsure, 0);      // the tangent
    check(std::nextafter(1.0, 2.0), 3, sphere, Meeting::kMisses, 0);
    check(0.6, 3, sphere, Meeting::kMeets, 1.1);
    const renderer::BoxBounds<double> box{{-1, -1, -1}, {1, 1, 1}};
    check(0, 3, box, Meeting::kMeets, 1);
    check(0, 0.5, box, Meeting::kMeets, 0.75);
    check(0, -3, box, Meeting::kMisses, 0);
    check(std::nextafter(1.0, 2.0), 3, box, Meeting::kMisses, 0);
    check(std::nextafter(1.0, 0.0), 3, box, Meeting::kMeets, 1);
    const renderer::PlaneKey plane{{0, 0, 1}, 1};
    check(0, 3, plane, Meeting::kMeets, 1);
    check(0, 0, plane, Meeting::kMisses, 0);
    check(0, 1, plane, Meeting::kUnsure, 0);
}

TEST_CASE("stability: where float and double name different triangles the exact answer decides") {
    // A fan of 64 thin triangles around the middle: rays at its edges meet either neighbour.
    SceneMaker make;
    make.scene.camera.center = {0.1, 0.2, 7};
    const auto rim = [](int k) {
        const math::SinCos turn = math::sincos(k * (2 * math::kPi / 64));
        return Vec3d{turn.cos, turn.sin, 0.1 * turn.sin * turn.cos};
    };
    for (int k = 0; k < 64; ++k) make.triangle({0.01, 0.02, 0.03}, rim(k), rim(k + 1));
    const Stability stability = measure_stability(make.scene, rays(200000));
    CHECK(stability.clean());
    const renderer::PrimitiveChanges& changes = stability.changes;
    CHECK(changes.rays > 100);
    CHECK(changes.for_double > 50);
    CHECK(changes.for_double > 10 * changes.for_float);
    CHECK(changes.rays == changes.for_double + changes.for_float + changes.for_both + changes.open);
}

TEST_CASE("stability: precision is told at the nearest and farthest hits and at the worst") {
    SceneMaker make;
    make.scene.camera.center = {0, 0, 10};
    const auto near = make.sphere({0, 0, 8}, 0.2);
    const auto far = make.box({-30, -30, -101}, {30, 30, -100});
    StabilityOptions options = rays(2000);
    options.height = 240;
    const Stability s = measure_stability(make.scene, options);
    REQUIRE(s.nearest);
    REQUIRE(s.farthest);
    REQUIRE(s.worst);
    CHECK(s.nearest->object == near);
    CHECK(s.nearest->distance == doctest::Approx(1.8).epsilon(0.02));
    CHECK(s.farthest->object == far);
    CHECK(s.farthest->distance > 109);
    // Twice the tangent of half the angle, over the rows.
    const double slope = 2 * math::tan(make.scene.camera.angle / 2) / 240;
    CHECK(s.nearest->pixel == doctest::Approx(s.nearest->distance * slope));
    // Coordinates up to 10: floats from 8 to 16 are 2^-20 apart.
    CHECK(s.nearest->step == 0x1p-20);
    CHECK(s.worst->ulps() <= s.nearest->ulps());
}

TEST_CASE("stability: it stops when told to, after a few rays for each object") {
    const SceneMaker make = gallery(1, {});
    StabilityOptions options = rays(100000);
    double last = -1;
    options.go_on = [&last](double fraction, std::uint64_t) {
        CHECK(fraction >= last);
        CHECK(fraction <= 1);
        last = fraction;
        return fraction < 0.5;
    };
    const Stability part = measure_stability(make.scene, options);
    CHECK(!part.complete);
    CHECK(part.rays > 2000);
    CHECK(part.rays < 6000);
    for (const ObjectStability& entry : part.objects) CHECK(entry.rays >= 256);
    options.go_on = {};
    CHECK(measure_stability(make.scene, options).complete);
}

}  // namespace cobble::test
