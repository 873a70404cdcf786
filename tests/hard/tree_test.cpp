// SPDX-License-Identifier: MIT
// The tree against brute force, bit for bit, over scenes that mix everything.
#include <doctest/doctest.h>

#include "tests/hard/scenes.hpp"

namespace cobble::test {

namespace {

/// Everything that a scene can hold, at rest and moving, some of it in the same place.
ir::Scene mixed_scene(std::uint64_t seed) {
    Random random(seed);
    SceneMaker make;
    for (int i = 0; i < 20; ++i) make.sphere(random.point(4), random.in(0.05, 0.8));
    for (int i = 0; i < 40; ++i) {
        const Vec3d at = random.point(4);
        make.triangle(at, at + random.point(1), at + random.point(1));
        // On the same spot, wound the other way: the tie rule must decide.
        if (i % 4 == 0) {
            const auto& v = make.scene.triangles.back().keys[0];
            make.triangle(v[0], v[2], v[1]);
        }
    }
    for (int i = 0; i < 15; ++i) {
        const Vec3d at{std::floor(random.in(-4, 4)), std::floor(random.in(-4, 4)),
                       std::floor(random.in(-4, 4))};
        make.box(at, at + Vec3d{1, 1, 1});
    }
    make.plane({0, 1, 0}, -4.5);
    make.plane(random.direction(), 6);
    const auto star = make.mesh(random_star(1, seed));
    for (int i = 0; i < 6; ++i) {
        make.again(star);
        make.place_last(
            {translation(random.point(4)) * rotation(random.direction(), random.in(0, 6)) *
             scaling({random.in(0.2, 1), random.in(-1, -0.2), random.in(0.2, 1)})});
    }
    for (int i = 0; i < 4; ++i) {
        const Vec3d axis = random.direction();
        const Vec3d at = random.point(3);
        std::vector<math::Affined> keys;
        for (int k = 0; k <= 4; ++k) {
            keys.push_back(translation(at + Vec3d{0.2 * k, 0, 0}) * rotation(axis, 0.25 * k) *
                           scaling({0.5, 0.7, 0.9}));
        }
        if (i % 2 == 0) make.again(star);
        if (i == 1) make.box({-1, -1, -1}, {1, 1, 1});
        if (i == 3) make.sphere({}, 1);
        make.place_last(keys);
        const Vec3d p = random.point(4);
        make.moving_sphere({{p, 0.3}, {p + random.point(1), 0.4}, {p + random.point(1), 0.2}});
        make.moving_triangle({{p, p + random.point(1), p + random.point(1)},
                              {p + random.point(1), p + random.point(1), p + random.point(1)}});
    }
    return make.scene;
}

/// Origins inside and outside; directions at random, along axes, diagonal, and almost along them.
template <typename T>
renderer::Ray<T> any_ray(Random& random) {
    renderer::Ray<T> r = ray<T>(random.point(8), random.direction());
    const auto kind = random.below(8);
    if (kind == 0) {
        const std::size_t axis = random.below(3);
        r.direction = {0, T(-0.0), 0};
        r.direction[axis] = random.below(2) == 0 ? T(1) : T(-1);
    }
    if (kind == 1) r.direction[random.below(3)] = 0;
    if (kind == 2) r.direction[random.below(3)] = std::numeric_limits<T>::denorm_min();
    if (kind == 3)
        r.origin = {std::floor(r.origin.x), std::floor(r.origin.y), std::floor(r.origin.z)};
    if (kind == 4) r.direction = r.direction * T(random.in(1e-3, 1e3));
    if (kind == 5) r.direction = {1, -1, random.below(2) == 0 ? T(1) : T(0)};
    r.time = static_cast<T>(random.unit());
    if (random.below(5) == 0) r.time = random.below(2) == 0 ? T(0) : T(1);
    if (random.below(4) == 0) r.t_max = static_cast<T>(random.in(1, 10));
    if (random.below(4) == 0) r.t_min = static_cast<T>(random.in(0, 3));
    return r;
}

template <typename T>
void compare(int rays_a_scene) {
    int hits = 0;
    int differences = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const ir::Scene scene = mixed_scene(seed);
        const auto prepared = renderer::prepare<T>(scene);
        Random random(seed + 100);
        for (int i = 0; i < rays_a_scene; ++i) {
            const auto r = any_ray<T>(random);
            renderer::Hit<T> hit;
            if (!tree_agrees(prepared, r, {}, &hit)) ++differences;
            if (!hit) continue;
            ++hits;
            // And on from there, as shading would.
            const auto s = renderer::surface_at(prepared, r, hit);
            const auto next = renderer::leave(s, random.direction().to<T>(), r.time);
            if (!tree_agrees(prepared, next.ray, next.exclude)) ++differences;
        }
    }
    CHECK(differences == 0);
    CHECK(hits > rays_a_scene);
}

}  // namespace

TEST_CASE("row 6: the tree equals brute force bit for bit, float") { compare<float>(20000); }
TEST_CASE("row 6: the tree equals brute force bit for bit, double") { compare<double>(4000); }

}  // namespace cobble::test
