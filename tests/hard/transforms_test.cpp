// SPDX-License-Identifier: MIT
// Matrices and motion: rows 26, 27, 28, 29 and 41 of the hard cases.
#include <doctest/doctest.h>

#include "renderer/query/query.hpp"
#include "tests/hard/scenes.hpp"
#include "tests/render/scene_builder.hpp"
#include "tests/support/record.hpp"

namespace cobble::test {

namespace {

math::Affined random_map(Random& random, double spread) {
    math::Affined shear;
    shear.rows[0][1] = random.in(-1, 1);
    const auto s = [&] { return std::pow(spread, random.in(-1, 1)); };
    const Vec3d by{s(), -s(), s()};
    return translation(random.point(3)) * rotation(random.direction(), random.in(0, 6)) * shear *
           scaling(by) * rotation(random.direction(), random.in(0, 6));
}

}  // namespace

TEST_CASE("row 26: the inverse's residual is that of rounding, and a singular map has none") {
    Random random(26);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto map = random_map(random, i % 2 == 0 ? 1e3 : 30);
        const auto inverse = math::inverse(map);
        REQUIRE(inverse);
        const auto product = map * *inverse;
        const double condition = math::condition(map, *inverse);
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) {
                const double off = std::fabs(product.rows[r][c] - (r == c ? 1 : 0));
                worst = std::max(worst, off / (64 * 0x1p-53 * condition));
            }
        }
    }
    CHECK(worst <= 1);
    record(26, "product with the inverse off 1 by " + brief(worst) + " of the bound at most");
    CHECK(math::inverse(scaling({1e-6, 1, 1e6})));
    CHECK(math::inverse(scaling({1e-200, 1e200, 1})));
    CHECK(!math::inverse(scaling({1, 0, 1})));
    CHECK(!math::inverse(scaling({1, std::numeric_limits<double>::quiet_NaN(), 1})));
    math::Affined flat;
    flat.rows = {{{1, 2, 3, 0}, {2, 4, 6, 0}, {1, 1, 1, 0}}};
    CHECK(!math::inverse(flat));
}

TEST_CASE("row 27: normals stay perpendicular and outside under uneven scale and mirrors") {
    Random random(27);
    renderer::Counters counters;
    double worst = 0;
    int hits = 0;
    int inward = 0;
    for (int i = 0; i < 200; ++i) {
        const auto map = random_map(random, 4);
        SceneMaker make;
        const Solid solid = icosphere(1);
        make.mesh(solid);
        make.place_last({map});
        const auto scene = renderer::prepare<float>(make.scene);
        const Vec3d center = map.point({});
        for (int k = 0; k < 50; ++k) {
            renderer::Ray<float> r;
            r.origin = scene.to_local(center + random.direction() * 100);
            r.direction = scene.to_local(map.point(random.point(0.5))) - r.origin;
            const auto hit = closest_hit(scene, r, {}, counters);
            if (!hit) continue;
            ++hits;
            const auto s = surface_at(scene, r, hit);
            const Vec3d n = s.geometric_normal.to<double>();
            const auto& f = solid.faces[hit.face];
            // The map as the instance means it: narrowed, then inverted.
            const auto& g = scene.geometry;
            const auto means = math::inverse(g.instance_keys[0].world_to_object.to<double>());
            REQUIRE(means);
            for (const auto& t : g.meshes[0].triangles) {
                if (t.face != hit.face) continue;
                for (std::size_t c = 1; c < 3; ++c) {
                    const Vec3d e = (t.vertices[c].to<double>() - t.vertices[0].to<double>());
                    const double off = std::fabs(dot(n, normalize(means->vector(e))));
                    worst = std::max(worst, off / (4 * 0x1p-23));
                }
            }
            inward += dot(n, map.point((solid.positions[f[0]] + solid.positions[f[1]] +
                                        solid.positions[f[2]]) /
                                       3.0) -
                                 center) > 0
                          ? 0
                          : 1;
        }
    }
    CHECK(hits > 8000);
    CHECK(worst <= 1);
    CHECK(inward == 0);
    record(27, "off a right angle by " + brief(4 * worst) + " ulp at most, " + counted(inward) +
                   " of " + counted(hits) + " turned in");
}

TEST_CASE("row 28: a mesh modelled 1e7 away and moved back is the mesh") {
    const Vec3d far{1e7, -1e7, 2e7};
    SceneMaker near;
    near.mesh(icosphere(2));
    near.place_last({math::Affined{}});
    SceneMaker back;
    back.mesh(transformed(icosphere(2), 1, far));
    back.place_last({translation(-far)});
    const auto a = renderer::prepare<float>(near.scene);
    const auto b = renderer::prepare<float>(back.scene);
    Random random(28);
    renderer::Counters counters;
    int differ = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d o = random.direction() * 3;
        const Vec3d d = normalize(random.point(0.6) - o);
        const auto x = closest_hit(a, ray<float>(o - a.origin, d), {}, counters);
        const auto y = closest_hit(b, ray<float>(o - b.origin, d), {}, counters);
        REQUIRE(bool(x) == bool(y));
        if (x) {
            CHECK(std::fabs(x.t - y.t) < 1e-5F);
            differ += x.face == y.face ? 0 : 1;
        }
    }
    CHECK(differ < 20);
    // And in pictures no step of eight bits tells.
    for (SceneMaker* make : {&near, &back}) {
        make->scene.camera.center = {0.3, 0.2, 4};
        make->scene.background.color = {0.2, 0.3, 0.5};
        ir::Light light;
        light.position = {3, 4, 5};
        light.color = {0.8, 0.8, 0.8};
        make->scene.lights.push_back(light);
    }
    const auto close = settings(64, 48, 1, effects({Effect::kShadows}));
    const auto x = render(near.scene, close).picture.color;
    const auto y = render(back.scene, close).picture.color;
    double worst = 0;
    for (std::size_t i = 0; i < x.values.size(); ++i) {
        worst = std::max(worst, std::fabs(double{x.values[i]} - double{y.values[i]}));
    }
    CHECK(worst <= 1 / 255.0);
    record(28, "pixels differ by " + brief(worst * 255) + " steps of 1/255 at most");
    CHECK(x.values[(24 * 64 + 32) * 3] != x.values[0]);
}

TEST_CASE("row 29: tangents from every kind of texture coordinates are finite, or none") {
    struct Row {
        Vec2d a, b, c;
        bool tangents;
    };
    const Row rows[] = {
        {{0, 0}, {1, 0}, {0, 1}, true},
        {{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}, false},
        {{0, 0}, {0, 0}, {1, 1}, false},
        {{0, 0}, {1, 1}, {2, 2}, false},
        {{0, 0}, {-1, 0}, {0, 1}, true},
        {{1e6, 1e6}, {1e6 + 1, 1e6}, {1e6, 1e6 + 1}, true},
        {{0, 0}, {1e-300, 0}, {0, 1e-300}, false},
        {{0, 0}, {1e6, 0}, {0, 1e-6}, true},
    };
    for (const Row& row : rows) {
        SceneMaker make;
        make.mesh({{{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}}, {{0, 1, 2}}});
        auto& mesh = make.scene.meshes[0];
        mesh.uvs = {row.a, row.b, row.c};
        for (std::uint32_t k = 0; k < 3; ++k) mesh.faces[0].corners[k].uv = k;
        const auto scene = renderer::prepare<float>(make.scene);
        renderer::Counters counters;
        renderer::Ray<float> r;
        r.origin = scene.to_local({-0.5, -0.5, 2});
        r.direction = {0, 0, -1};
        const auto hit = closest_hit(scene, r, {}, counters);
        REQUIRE(hit);
        const auto s = surface_at(scene, r, hit);
        CHECK(s.has_uv);
        CHECK(s.has_tangents == row.tangents);
        CHECK(std::fabs(s.uv.x - (row.a.x + 0.25 * (row.b.x - row.a.x) +
                                  0.25 * (row.c.x - row.a.x))) <= 1e-6 * (1 + std::fabs(row.a.x)));
        CHECK(length(s.dp_du) + length(s.dp_dv) < std::numeric_limits<float>::infinity());
        if (!row.tangents) {
            CHECK(s.dp_du == Vec3<float>{});
            continue;
        }
        // Moving by (du, dv) moves the point: from the first corner to the second.
        const auto moved = s.dp_du * static_cast<float>(row.b.x - row.a.x) +
                           s.dp_dv * static_cast<float>(row.b.y - row.a.y);
        CHECK(length(moved - Vec3<float>{2, 0, 0}) < 1e-5F);
        const auto off =
            renderer::prepare<float>(make.scene, {renderer::Acceleration::kBvh, false});
        CHECK(!surface_at(off, r, closest_hit(off, r, {}, counters)).has_uv);
    }
}

TEST_CASE("row 41: keys are met exactly, and no moving thing leaves its box") {
    SceneMaker make;
    Random random(41);
    std::vector<std::array<Vec3d, 3>> keys;
    std::vector<ir::Sphere::Key> spheres;
    std::vector<math::Affined> maps;
    for (int k = 0; k <= 16; ++k) {
        keys.push_back({random.point(3), random.point(3), random.point(3)});
        spheres.push_back({random.point(3), random.in(0.1, 1)});
        // Half a turn in steps of at most 15 degrees, while it moves and grows.
        maps.push_back(translation({0.3 * k, 0, 1}) *
                       rotation(normalize(Vec3d{1, 2, -1}), math::kPi * k / 16) *
                       scaling({1 + 0.1 * k, 1, 0.5}));
    }
    make.moving_triangle(keys);
    make.moving_sphere(spheres);
    make.box({-1, -2, -0.5}, {1, 2, 0.5});
    make.place_last(maps);
    const auto scene = renderer::prepare<float>(make.scene);
    const auto& g = scene.geometry;
    for (std::uint32_t k = 0; k <= 16; ++k) {
        const float time = static_cast<float>(k) / 16;
        CHECK(renderer::triangle_at(g, g.moving_triangles[0], time) == g.triangle_keys[k]);
        CHECK(renderer::sphere_at(g, g.moving_spheres[0], time).center == g.sphere_keys[k].center);
        CHECK(renderer::world_to_object_at(g, g.instances[0], time) ==
              g.instance_keys[k].world_to_object);
    }
    // The boxes as the tree holds them: leaves by kind.
    renderer::BoxBounds<float> boxes[renderer::kPrimitiveKinds];
    for (const auto& node : g.tree.nodes) {
        for (std::size_t k = 0; k < 4; ++k) {
            if (node.count[k] == 0) continue;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                auto& box = boxes[static_cast<std::size_t>(node.kind[k])];
                box.lo[axis] = node.bounds[0][axis][k];
                box.hi[axis] = node.bounds[1][axis][k];
            }
        }
    }
    const auto holds = [](const renderer::BoxBounds<float>& box,
                          const renderer::BoxBounds<float>& inner) {
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) {
            inside = inside && box.lo[i] <= inner.lo[i] && inner.hi[i] <= box.hi[i];
        }
        return inside;
    };
    using Kind = renderer::PrimitiveKind;
    const auto& triangle_box = boxes[static_cast<std::size_t>(Kind::kMovingTriangle)];
    const auto& sphere_box = boxes[static_cast<std::size_t>(Kind::kMovingSphere)];
    const auto& instance_box = boxes[static_cast<std::size_t>(Kind::kInstance)];
    int escapes = 0;
    for (int i = 0; i < 100000; ++i) {
        const auto time = static_cast<float>(random.unit());
        const auto v = renderer::triangle_at(g, g.moving_triangles[0], time);
        const auto s = renderer::sphere_at(g, g.moving_spheres[0], time);
        escapes += holds(triangle_box, renderer::bounds_of(v)) ? 0 : 1;
        escapes += holds(sphere_box, renderer::bounds_of(s.center, s.radius)) ? 0 : 1;
        if (i % 10 != 0) continue;
        const auto map = renderer::world_to_object_at(g, g.instances[0], time).to<double>();
        const auto back = math::inverse(map);
        renderer::BoxBounds<double> image;
        const auto& b = g.instances[0].box.bounds;
        for (unsigned c = 0; c < 8; ++c) {
            image.add(
                back->point(Vec3d{(c & 1U) != 0 ? b.hi.x : b.lo.x, (c & 2U) != 0 ? b.hi.y : b.lo.y,
                                  (c & 4U) != 0 ? b.hi.z : b.lo.z}));
        }
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) {
            inside = inside && double{instance_box.lo[k]} <= image.lo[k] &&
                     image.hi[k] <= double{instance_box.hi[k]};
        }
        escapes += inside ? 0 : 1;
    }
    CHECK(escapes == 0);
    record(41, counted(escapes) + " of 210,000 boxes left");
}

}  // namespace cobble::test
