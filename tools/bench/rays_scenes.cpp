// SPDX-License-Identifier: MIT
#include "tools/bench/rays_scenes.hpp"

#include <cmath>
#include <utility>

#include "ir/math/elementary.hpp"

namespace cobble::bench {

using math::Vec3d;

namespace {

std::uint64_t next_bits(std::uint64_t& state) {
    // splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
    state += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
}

void add_object(ir::Scene& scene, ir::ShapeKind kind, std::size_t shape) {
    ir::Object object;
    object.kind = kind;
    object.shape = static_cast<std::uint32_t>(shape);
    object.material = ir::MaterialId{0};
    scene.objects.push_back(object);
}

ir::Scene empty_scene() {
    ir::Scene scene;
    scene.materials.emplace_back();
    scene.camera.center = {0, 0.6, 3};
    return scene;
}

}  // namespace

double next_unit(std::uint64_t& state) {
    return static_cast<double>(next_bits(state) >> 11) * 0x1p-53;
}

Vec3d next_direction(std::uint64_t& state) {
    const double z = 2 * next_unit(state) - 1;
    const auto a = math::sincos(2 * math::kPi * next_unit(state));
    const double r = std::sqrt(1 - z * z);
    return {r * a.cos, r * a.sin, z};
}

ir::Scene mesh_scene(std::uint32_t n) {
    ir::Scene scene = empty_scene();
    ir::Mesh mesh;
    for (std::uint32_t i = 0; i <= n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
            const auto a = math::sincos(math::kPi * i / n);
            const auto b = math::sincos(2 * math::kPi * j / n);
            const double wave = math::sin(9 * a.cos) * math::sin(7 * b.cos);
            const double r = 1 + 0.1 * wave;
            mesh.positions.push_back({r * a.sin * b.cos, r * a.cos, r * a.sin * b.sin});
        }
    }
    constexpr auto kNone = ir::Mesh::kNone;
    const auto face = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.faces.push_back({{{{a, kNone, kNone}, {b, kNone, kNone}, {c, kNone, kNone}}}});
    };
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t k = (j + 1) % n;
            if (i > 0) face(i * n + j, i * n + k, (i + 1) * n + j);
            if (i + 1 < n) face(i * n + k, (i + 1) * n + k, (i + 1) * n + j);
        }
    }
    scene.meshes.push_back(std::move(mesh));
    add_object(scene, ir::ShapeKind::kMesh, 0);
    return scene;
}

ir::Scene sphere_scene(std::uint32_t n) {
    ir::Scene scene = empty_scene();
    std::uint64_t state = 1;
    for (std::uint32_t i = 0; i < n; ++i) {
        const Vec3d at = next_direction(state) * next_unit(state);
        scene.spheres.push_back({{{at, 0.02 + 0.02 * next_unit(state)}}});
        add_object(scene, ir::ShapeKind::kSphere, i);
    }
    return scene;
}

}  // namespace cobble::bench
