// SPDX-License-Identifier: MIT
// One small scene that calls for every effect.
#pragma once

#include <cstdint>
#include <utility>

#include "tests/render/scene_builder.hpp"

namespace cobble::test {

/// Numbers without a pattern, `size` texels square.
inline ir::Image scrambled_image(std::uint32_t size, std::uint32_t seed) {
    ir::Image image;
    image.width = image.height = size;
    for (std::uint32_t i = 0; i < 3 * size * size; ++i) {
        seed = seed * 1664525U + 1013904223U;
        image.bytes.push_back(static_cast<std::uint8_t>(seed >> 24U));
    }
    return image;
}

/// A tetrahedron around zero, its normals those of a ball, with texture coordinates.
inline ir::Mesh smooth_tetrahedron() {
    ir::Mesh mesh;
    mesh.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (const Vec3d p : mesh.positions) mesh.normals.push_back(math::normalize(p));
    mesh.uvs = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    constexpr std::uint32_t kFaces[4][3] = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    for (const auto& f : kFaces) {
        mesh.faces.push_back({{{{f[0], f[0], f[0]}, {f[1], f[1], f[1]}, {f[2], f[2], f[2]}}}});
    }
    mesh.face_offsets.assign(mesh.faces.size(), 0);
    return mesh;
}

/// Something of every effect, every shape and every way to place one.
inline SceneBuilder everything() {
    SceneBuilder b;
    b.background({0.3, 0.4, 0.6}, {0.1, 0.1, 0.1});
    b.camera({0, 2, 8}, {0, -0.2, -1}, 0.7).lens(0.2, 8, 6).shutter(0, 1);
    ir::Image checks;
    checks.width = checks.height = 4;
    for (int i = 0; i < 48; ++i) checks.bytes.push_back(static_cast<std::uint8_t>((37 * i) % 256));
    const ir::ImageId image = b.image(checks);
    ir::Material& floor = b.material({0.8, 0.6, 0.4}, {0.1, 0.1, 0.1}, 10);
    floor.texture = image;
    floor.normal_map = image;
    b.plane({0, 1, 0}, 0);
    ir::Material& marble = b.material({1, 1, 1});
    marble.has_noise = true;
    marble.noise = {{1, 1, 1}, {0.2, 0.1, 0.1}, 5, 4, 3};
    b.moving_sphere({-1.5, 1, 0}, {-1.2, 1.3, 0.2}, 0.9);
    b.material({0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, 40, 1.5);
    b.sphere({1.3, 1, 1}, 0.9);
    b.box({-0.5, 0, 2}, {0.4, 0.8, 3});
    ir::CubeMap sky;
    for (std::uint32_t face = 0; face < 6; ++face) {
        sky.faces[face] = b.image(scrambled_image(8, 100 + face));
    }
    b.scene().cube_maps.push_back(sky);
    b.scene().background.cube_map = {0};
    ir::Material& shiny = b.material({0.2, 0.5, 0.3});
    shiny.cube_map = {0};
    b.triangle({-3, 0, -1}, {-2, 0, -2}, {-2.6, 2.5, -1.5});
    const ir::ImageId bumps = b.image(scrambled_image(16, 7));
    b.material({0.9, 0.9, 0.7}, {0.2, 0.2, 0.2}, 12).bump_map = bumps;
    b.mesh(smooth_tetrahedron());
    ir::Placement placement;
    placement.object_to_world.rows = {{{0.5, 0, 0, 0}, {0, 0.75, 0, 1}, {0, 0, 0.5, -2}}};
    placement.world_to_object.rows = {{{2, 0, 0, 0}, {0, 4 / 3.0, 0, -4 / 3.0}, {0, 0, 2, 4}}};
    b.scene().placements.push_back(placement);
    b.scene().objects.back().placement = {0, 1};
    b.point_light({-3, 6, 4}, {0.7, 0.7, 0.7}, 0.5, 0.01);
    b.sun({0.4, -1, -0.3}, {0.3, 0.3, 0.3}, 0.05);
    return b;
}

}  // namespace cobble::test
