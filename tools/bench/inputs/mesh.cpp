// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "ir/math/elementary.hpp"
#include "tools/bench/inputs/input.hpp"
#include "tools/bench/inputs/random.hpp"

namespace cobble::bench {

using math::Vec3d;

namespace {

/// 2 n (n - 1) triangles: latitudes by longitudes, with a triangle at each end.
void add_ball(ir::Mesh& mesh, std::size_t n, Vec3d center) {
    const std::size_t first = mesh.positions.size();
    const auto steps = static_cast<double>(n);
    for (std::size_t i = 0; i <= n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const auto a = math::sincos(math::kPi * static_cast<double>(i) / steps);
            const auto b = math::sincos(2 * math::kPi * static_cast<double>(j) / steps);
            const double wave = math::sin(9 * a.cos) * math::sin(7 * b.cos) +
                                0.3 * math::sin(40 * a.cos + 5 * b.sin);
            const double r = 1 + 0.1 * wave * a.sin;
            mesh.positions.push_back(center + Vec3d{a.sin * b.cos, a.cos, a.sin * b.sin} * r);
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t row = first + i * n;
        for (std::size_t j = 0; j < n; ++j) {
            const std::size_t k = (j + 1) % n;
            if (i > 0) add_face(mesh, row + j, row + k, row + n + j);
            if (i + 1 < n) add_face(mesh, row + k, row + n + k, row + n + j);
        }
    }
}

/// 2 n n triangles over the square [-4, 4].
void add_hills(ir::Mesh& mesh, std::size_t n) {
    const std::size_t first = mesh.positions.size();
    for (std::size_t i = 0; i <= n; ++i) {
        for (std::size_t j = 0; j <= n; ++j) {
            const double x = 8 * static_cast<double>(j) / static_cast<double>(n) - 4;
            const double z = 8 * static_cast<double>(i) / static_cast<double>(n) - 4;
            const double y = 0.25 * math::sin(2.1 * x + 0.5) * math::sin(1.7 * z) +
                             0.08 * math::sin(7 * x + 3 * z) + 0.02 * math::sin(31 * z - 23 * x);
            mesh.positions.push_back({x, y, z});
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const std::size_t a = first + i * (n + 1) + j;
            const std::size_t b = a + n + 1;
            add_face(mesh, a, b, a + 1);
            add_face(mesh, a + 1, b, b + 1);
        }
    }
}

/// A twig of two crossed quadrilaterals' worth of leaves, anywhere in the crown.
void add_leaf(ir::Mesh& mesh, Random& random) {
    const double far = std::sqrt(random.unit());
    const Vec3d at = random.direction() * far;
    const Vec3d middle{1.1 * at.x, 2.6 + 1.3 * at.y, 1.1 * at.z};
    const Vec3d along = random.direction();
    const Vec3d across = normalize(cross(along, random.direction())) * 0.08;
    const std::size_t first = mesh.positions.size();
    mesh.positions.push_back(middle - along * 0.12);
    mesh.positions.push_back(middle + across);
    mesh.positions.push_back(middle + along * 0.12);
    mesh.positions.push_back(middle - across);
    add_face(mesh, first, first + 1, first + 2);
    add_face(mesh, first, first + 2, first + 3);
}

ir::Mesh tree_mesh() {
    ir::Mesh mesh;
    constexpr std::size_t kAround = 12;
    constexpr std::size_t kUp = 10;
    for (std::size_t i = 0; i <= kUp; ++i) {
        const double y = 3.2 * static_cast<double>(i) / kUp;
        for (std::size_t j = 0; j < kAround; ++j) {
            const auto a = math::sincos(2 * math::kPi * static_cast<double>(j) / kAround);
            const double r = 0.18 * (1 - y / 3.6);
            mesh.positions.push_back({r * a.cos, y, r * a.sin});
        }
    }
    for (std::size_t i = 0; i < kUp; ++i) {
        for (std::size_t j = 0; j < kAround; ++j) {
            const std::size_t a = i * kAround + j;
            const std::size_t b = i * kAround + (j + 1) % kAround;
            add_face(mesh, a, a + kAround, b);
            add_face(mesh, b, a + kAround, b + kAround);
        }
    }
    Random random(3);
    for (int i = 0; i < 1400; ++i) add_leaf(mesh, random);
    return mesh;
}

/// Turned about y by `turn`, scaled by `size`, moved to (x, 0, z); both ways in closed form.
ir::Placement stand(double turn, double size, double x, double z) {
    const auto a = math::sincos(turn);
    ir::Placement place;
    place.object_to_world.rows = {
        {{size * a.cos, 0, size * a.sin, x}, {0, size, 0, 0}, {-size * a.sin, 0, size * a.cos, z}}};
    const double s = 1 / size;
    place.world_to_object.rows = {{{s * a.cos, 0, -s * a.sin, -s * (a.cos * x - a.sin * z)},
                                   {0, s, 0, 0},
                                   {s * a.sin, 0, s * a.cos, -s * (a.sin * x + a.cos * z)}}};
    return place;
}

}  // namespace

Input mesh_input(std::uint32_t triangles) {
    Input input;
    input.scene = empty_scene({3, 5, 2});
    aim_camera(input.scene, {0.4, 1.9, 4.2}, {0, 0.75, 0}, 45 * math::kPi / 180);
    ir::Mesh mesh;
    const auto n = static_cast<std::size_t>(std::sqrt(triangles / 4.0));
    add_ball(mesh, n, {0, 1.25, 0});
    add_hills(mesh, n);
    input.title = fmt::format("mesh, {} triangles", mesh.faces.size());
    input.scene.meshes.push_back(std::move(mesh));
    add_object(input.scene, ir::ShapeKind::kMesh, 0);
    return input;
}

Input sphere_input(std::uint32_t count) {
    Input input;
    input.title = fmt::format("{} spheres", count);
    input.scene = empty_scene({3, 4, 2});
    aim_camera(input.scene, {0, 0.6, 2.6}, {0, 0, 0}, 45 * math::kPi / 180);
    Random random(1);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double far = random.unit();
        const Vec3d at = random.direction() * far;
        input.scene.spheres.push_back({{{at, random.between(0.02, 0.04)}}});
        add_object(input.scene, ir::ShapeKind::kSphere, i);
    }
    return input;
}

Input forest_input(std::uint32_t count) {
    Input input;
    const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
    constexpr double kSpacing = 2.5;
    const double half = 0.5 * kSpacing * side;
    input.scene = empty_scene({0.3 * half, 60, 0.5 * half});
    aim_camera(input.scene, {0, 14, half + 6}, {0, 0, half - 30}, 45 * math::kPi / 180);
    ir::Mesh ground;
    ground.positions = {{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}};
    add_face(ground, 0, 3, 2);
    add_face(ground, 0, 2, 1);
    input.scene.meshes = {std::move(ground), tree_mesh()};
    add_object(input.scene, ir::ShapeKind::kMesh, 0);
    Random random(5);
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const double turn = random.between(0, 2 * math::kPi);
        const double size = random.between(0.7, 1.3);
        const double x = (i % side + random.between(0.2, 0.8)) * kSpacing - half;
        const double z = (i / side + random.between(0.2, 0.8)) * kSpacing - half;
        add_object(input.scene, ir::ShapeKind::kMesh, 1);
        input.scene.objects.back().placement = {
            static_cast<std::uint32_t>(input.scene.placements.size()), 1};
        input.scene.placements.push_back(stand(turn, size, x, z));
    }
    input.title = fmt::format("a tree of {} triangles, {} times",
                              input.scene.meshes[1].faces.size(), side * side);
    return input;
}

}  // namespace cobble::bench
