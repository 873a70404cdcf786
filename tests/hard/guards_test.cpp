// SPDX-License-Identifier: MIT
// Guards against numbers that are none, or too large or small to reckon with, that no other test
// comes to. Each of these was seen to pass through its guard.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "renderer/stability/exact.hpp"
#include "tests/hard/cores.hpp"

namespace cobble::test {

namespace {

/// A bundle of one ray, again and again with directions of other lengths: enough for a packet.
template <typename T>
void ask_bundle(Questions<T>& cores, renderer::Ray<T> r) {
    const Vec3<T> direction = r.direction;
    for (int i = 0; i < 64; ++i) {
        r.direction = direction * std::ldexp(T(1), i % 4);
        cores.ask(r);
    }
}

std::size_t hits_of(const Questions<float>& cores) {
    std::size_t hits = 0;
    for (const auto& hit : cores.answers) hits += hit.object.valid() ? 1 : 0;
    return hits;
}

}  // namespace

TEST_CASE("spheres are met along directions of any length") {
    SceneMaker make;
    for (int i = 0; i < 6; ++i) make.sphere({double(i % 3), double(i % 2), 0.1 * i}, 0.6);
    Questions<float> cores(make.scene);
    for (const int power : {-62, -55, -51, -45, -21, 21, 45, 51, 55, 62}) {
        renderer::Ray<float> r;
        r.origin = cores.reference.to_local({0.5, 0.25, 9});
        r.direction = Vec3<float>{0.015625F, 0.03125F, -1} * std::ldexp(1.0F, power);
        ask_bundle(cores, r);
    }
    CHECK(hits_of(cores) == cores.rays.size());
    CHECK(cores.differences() == "");
}

TEST_CASE("no sphere that a packet puts aside in float is one that a ray meets") {
    // Of any size, as far away as may be, from outside, from its surface and from within, past its
    // outline or beyond the ray's end by a few roundings, along directions of any length.
    Random random(7);
    const auto power = [&](int most) {
        const auto range = static_cast<std::uint32_t>(2 * most + 1);
        const int to = static_cast<int>(random.below(range)) - most;
        return std::ldexp(random.in(1, 2), to);
    };
    const auto few_roundings = [&] {
        const int least = static_cast<int>(random.below(30));
        const double off = std::ldexp(random.in(-1, 1), -least);
        return random.below(4) == 0 ? 0 : off;
    };
    std::size_t hits = 0;
    std::size_t asked = 0;
    for (int scene = 0; scene < 400; ++scene) {
        SceneMaker make;
        const double size = power(scene % 2 == 0 ? 4 : 60);
        const Vec3d place = random.point(random.below(2) == 0 ? 0 : size * power(20));
        for (int i = 0; i < 3; ++i) {
            const Vec3d middle = place + random.point(size * power(3));
            make.sphere(middle, size * power(random.below(2) == 0 ? 0 : 20));
        }
        Questions<float> cores(make.scene);
        if (cores.reference.geometry.spheres.empty()) continue;
        const auto& sphere = cores.reference.geometry.spheres[0];
        const Vec3d center = sphere.center.to<double>();
        const double r = double{sphere.radius};
        for (int bundle = 0; bundle < 6; ++bundle) {
            const Vec3d out = math::normalize(random.point(1));
            const Vec3d aside = math::normalize(math::cross(out, random.point(1)));
            const double far = random.below(3) == 0 ? 1 + few_roundings() : power(25);
            const double length = power(random.below(2) == 0 ? 0 : 59);
            const std::uint32_t aim = random.below(4);
            for (int i = 0; i < 64; ++i) {
                renderer::Ray<float> ray;
                const Vec3d from = center + out * (r * (far + few_roundings()));
                // Past the outline, through the middle, anywhere, or away.
                const double rim = std::sqrt(std::max(0.0, 1 - 1 / (far * far)));
                Vec3d target = center + aside * (r * rim * (1 + few_roundings()));
                if (far > 1) target = target + out * (r / far);
                if (aim == 1) target = center + aside * (r * few_roundings());
                if (aim == 2) target = center + random.point(r);
                Vec3d way = target - from;
                if (aim == 3) way = way * -1.0;
                if (way == Vec3d{}) continue;
                way = math::normalize(way);
                ray.origin = from.to<float>();
                ray.direction = (way * (length * random.in(1, 2))).to<float>();
                const Vec3d d = ray.direction.to<double>();
                const Vec3d f = ray.origin.to<double>() - center;
                if (random.below(2) == 0) {
                    // About where it meets the sphere, or comes nearest to it.
                    const double a = math::dot(d, d);
                    const double b = -math::dot(f, d);
                    const double rest = b * b - a * (math::dot(f, f) - r * r);
                    const double root = rest > 0 ? std::sqrt(rest) : 0;
                    const double t = (b + (random.below(3) == 0 ? root : -root)) / a;
                    const double end = t * (1 + few_roundings());
                    if (end > 0 && end < 1e38) ray.t_max = static_cast<float>(end);
                }
                renderer::Exclude exclude;
                if (random.below(3) == 0) {
                    exclude = {ir::ObjectId{random.below(3)}, 0, random.below(2) == 0};
                }
                const float most = std::numeric_limits<float>::max();
                bool sound = ray.direction.x != 0 || ray.direction.y != 0 || ray.direction.z != 0;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    sound = sound && std::fabs(ray.origin[axis]) <= most &&
                            std::fabs(ray.direction[axis]) <= most;
                }
                if (!sound) continue;
                cores.ask(ray, exclude);
            }
        }
        CAPTURE(scene);
        CHECK(cores.differences() == "");
        hits += hits_of(cores);
        asked += cores.rays.size();
    }
    CHECK(hits > asked / 8);
    CHECK(hits < asked);
}

TEST_CASE("a packet's slopes that vanish are none") {
    SceneMaker make;
    for (int i = 0; i < 8; ++i) {
        const double z = 0.25 * i;
        make.triangle({-1, -1, z}, {2, -1, z}, {-1, 2, z + 0.1});
    }
    Questions<float> cores(make.scene);
    renderer::Ray<float> r;
    r.origin = cores.reference.to_local({0.25, 0.25, 9});
    r.direction = {0x1p-110F, 0x1p-105F, -1};
    ask_bundle(cores, r);
    r.direction = {0x1p-110F, 0.03125F, -1};
    ask_bundle(cores, r);
    CHECK(hits_of(cores) == cores.rays.size());
    CHECK(cores.differences() == "");
}

TEST_CASE("a packet's triangles that are seen edge-on but for roundings") {
    // The rays lie in the planes of the triangles, exactly: only sheared do these have an area.
    Random random(20);
    std::size_t hits = 0;
    for (int scene = 0; scene < 200; ++scene) {
        const auto whole = [&](double most) {
            const Vec3d p = random.point(most);
            return Vec3d{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
        };
        const Vec3d along{1 + std::floor(random.in(0, 9)), 1 + std::floor(random.in(0, 9)), 11};
        const Vec3d eye = whole(50) * 0.0078125;
        const Vec3d aside = whole(40);
        SceneMaker make;
        const auto corner = [&](double least) {
            return eye + along * (least + std::floor(random.in(0, 50))) +
                   aside * (std::floor(random.in(-20, 20)) * 0.0009765625);
        };
        make.triangle(corner(1), corner(20), corner(60));
        Questions<float> cores(make.scene);
        renderer::Ray<float> r;
        r.origin = cores.reference.to_local(eye);
        r.direction = along.to<float>();
        ask_bundle(cores, r);
        CHECK(cores.differences() == "");
        hits += hits_of(cores);
    }
    CHECK(hits > 0);
}

TEST_CASE("the rim of a plate has no texture coordinates that are no numbers") {
    for (std::size_t flat = 0; flat < 3; ++flat) {
        CAPTURE(flat);
        SceneMaker make;
        Vec3d hi{1, 1, 1};
        hi[flat] = 0;
        make.box({0, 0, 0}, hi);
        Questions<float> cores(make.scene);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (axis == flat) continue;
            Vec3d from{0.25, 0.25, 0.25};
            from[flat] = 0;
            from[axis] = 5;
            Vec3d along{};
            along[axis] = -1;
            renderer::Ray<float> r;
            r.origin = cores.reference.to_local(from);
            r.direction = along.to<float>();
            const auto hit = cores.ask(r);
            REQUIRE(hit);
            const auto surface = surface_at(cores.reference, r, hit);
            CHECK(std::isfinite(surface.uv.x));
            CHECK(std::isfinite(surface.uv.y));
        }
        CHECK(cores.differences() == "");
    }
}

TEST_CASE("a tree over things so near to each other that bins have no width") {
    SceneMaker make;
    for (int i = 0; i < 40; ++i) make.sphere({i * 1e-322, 0, 0}, 1e-310);
    for (const auto core : {renderer::Acceleration::kBvh, renderer::Acceleration::kFast}) {
        renderer::PrepareOptions options;
        options.acceleration = core;
        const auto scene = renderer::prepare<double>(make.scene, options);
        CHECK(scene.notes.empty());
        const auto& g = scene.geometry;
        CHECK(g.tree.nodes.size() + g.wide.nodes.size() > 1);
    }
}

TEST_CASE("planes without a normal or beyond all numbers are noted and never hit") {
    SceneMaker make;
    make.plane({0, 0, 0}, 1);
    make.plane({0, 1, 0}, 1e301);
    make.plane({0, 1, 0}, std::numeric_limits<double>::quiet_NaN());
    const auto good = make.plane({0, 1, 0}, -1);
    Questions<float> cores(make.scene);
    using Kind = renderer::PreparationNote::Kind;
    REQUIRE(cores.reference.notes.size() == 3);
    CHECK(cores.reference.notes[0].kind == Kind::kDegenerate);
    CHECK(cores.reference.notes[1].kind == Kind::kOutOfRange);
    CHECK(cores.reference.notes[2].kind == Kind::kOutOfRange);
    renderer::Ray<float> r;
    r.origin = cores.reference.to_local({0, 5, 0});
    r.direction = {0.25F, -1, 0.125F};
    CHECK(cores.ask(r).object == good);
    CHECK(cores.differences() == "");
}

TEST_CASE("an instance whose box can not be told may be anywhere") {
    const double most = double{std::numeric_limits<float>::max()} / 8;
    {
        SceneMaker make;
        make.sphere({0, 0, 0}, 1);
        make.place_last({scaling({1e38, 1e38, 1e38})});
        Questions<float> cores(make.scene);
        REQUIRE(cores.reference.geometry.instances.size() == 1);
        CHECK(double{cores.reference.geometry.instances[0].world_bounds.hi.x} == most);
        cores.ask(ray<float>({0, 0, 0}, {0.25, 0.5, -1}));
        CHECK(cores.differences() == "");
    }
    // Its map's inverse grows a million times within a step of the motion.
    SceneMaker make;
    make.sphere({0, 0, 0}, 1);
    make.place_last({scaling({1, 1, 1}), scaling({1e6, 1e6, 1e6})});
    Questions<float> cores(make.scene);
    REQUIRE(cores.reference.geometry.instances.size() == 1);
    CHECK(double{cores.reference.geometry.instances[0].world_bounds.hi.x} == most);
    Random random(50);
    for (int i = 0; i < 200; ++i) {
        auto r = ray<float>(random.point(9), random.direction());
        r.time = static_cast<float>(random.unit());
        cores.ask(r);
    }
    CHECK(hits_of(cores) > 0);
    CHECK(cores.differences() == "");
}

TEST_CASE("what has too many digits for an exact answer is left unsure") {
    using renderer::Meeting;
    renderer::Ray<double> r;
    r.origin = {0, 0, 5};
    r.direction = {0, 0, -1};
    const auto met = [&](double size) {
        const std::array<Vec3d, 3> v{Vec3d{-size, -size, 0}, {size, -size, 0}, {0, size, 0}};
        return meet_exactly(r, v).meeting;
    };
    CHECK(met(1) == Meeting::kMeets);
    CHECK(met(1e91) == Meeting::kUnsure);
    CHECK(met(1e-91) == Meeting::kUnsure);
    CHECK(met(std::numeric_limits<double>::infinity()) == Meeting::kUnsure);
    CHECK(met(std::numeric_limits<double>::quiet_NaN()) == Meeting::kUnsure);
}

}  // namespace cobble::test
