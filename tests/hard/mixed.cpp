// SPDX-License-Identifier: MIT
#include "tests/hard/mixed.hpp"

namespace cobble::test {

ir::Scene mixed_scene(std::uint64_t seed, bool with_boxes) {
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
        if (with_boxes) make.box(at, at + Vec3d{1, 1, 1});
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

}  // namespace cobble::test
