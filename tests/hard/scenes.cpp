// SPDX-License-Identifier: MIT
#include "tests/hard/scenes.hpp"

#include <map>
#include <utility>

namespace cobble::test {

Solid icosphere(int subdivisions) {
    const double g = (1 + std::sqrt(5.0)) / 2;
    Solid s;
    s.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    s.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (auto& p : s.positions) p = normalize(p);
    for (int i = 0; i < subdivisions; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
        const auto between = [&](std::uint32_t a, std::uint32_t b) {
            const auto key = a < b ? std::pair{a, b} : std::pair{b, a};
            const auto found = middle.find(key);
            if (found != middle.end()) return found->second;
            const auto index = static_cast<std::uint32_t>(s.positions.size());
            s.positions.push_back(normalize(s.positions[a] + s.positions[b]));
            middle[key] = index;
            return index;
        };
        std::vector<std::array<std::uint32_t, 3>> faces;
        for (const auto& f : s.faces) {
            const auto a = between(f[0], f[1]);
            const auto b = between(f[1], f[2]);
            const auto c = between(f[2], f[0]);
            faces.push_back({f[0], a, c});
            faces.push_back({f[1], b, a});
            faces.push_back({f[2], c, b});
            faces.push_back({a, b, c});
        }
        s.faces = std::move(faces);
    }
    return s;
}

Solid random_star(int subdivisions, std::uint64_t seed) {
    Solid s = icosphere(subdivisions);
    Random random(seed);
    for (auto& p : s.positions) p = p * random.in(0.3, 1.7);
    return s;
}

Solid square_prism() {
    Solid s;
    s.positions = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                   {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    s.faces = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
               {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    return s;
}

Solid transformed(Solid solid, double scale, Vec3d offset) {
    for (auto& p : solid.positions) p = p * scale + offset;
    return solid;
}

SceneMaker::SceneMaker() {
    scene.camera.forward = {0, 0, -1};
    scene.camera.up = {0, 1, 0};
    scene.camera.right = {1, 0, 0};
    scene.camera.angle = 0.5;
    scene.materials.emplace_back();
}

ir::ObjectId SceneMaker::add(ir::ShapeKind kind, std::size_t shape) {
    ir::Object object;
    object.kind = kind;
    object.shape = static_cast<std::uint32_t>(shape);
    object.material = ir::MaterialId{0};
    scene.objects.push_back(object);
    return ir::ObjectId{static_cast<std::uint32_t>(scene.objects.size() - 1)};
}

ir::ObjectId SceneMaker::sphere(Vec3d center, double radius) {
    return moving_sphere({{center, radius}});
}

ir::ObjectId SceneMaker::moving_sphere(std::vector<ir::Sphere::Key> keys) {
    scene.spheres.push_back({std::move(keys)});
    return add(ir::ShapeKind::kSphere, scene.spheres.size() - 1);
}

ir::ObjectId SceneMaker::triangle(Vec3d a, Vec3d b, Vec3d c) {
    return moving_triangle({{a, b, c}});
}

ir::ObjectId SceneMaker::moving_triangle(std::vector<std::array<Vec3d, 3>> keys) {
    scene.triangles.push_back({std::move(keys)});
    return add(ir::ShapeKind::kTriangle, scene.triangles.size() - 1);
}

ir::ObjectId SceneMaker::box(Vec3d lo, Vec3d hi) {
    scene.boxes.push_back({lo, hi});
    return add(ir::ShapeKind::kBox, scene.boxes.size() - 1);
}

ir::ObjectId SceneMaker::plane(Vec3d normal, double offset) {
    ir::Plane p;
    p.normal = normalize(normal);
    p.offset = offset;
    const Vec3d other = std::fabs(p.normal.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    p.u_axis = normalize(cross(other, p.normal));
    p.v_axis = cross(p.normal, p.u_axis);
    scene.planes.push_back(p);
    return add(ir::ShapeKind::kPlane, scene.planes.size() - 1);
}

ir::ObjectId SceneMaker::mesh(const Solid& solid) {
    ir::Mesh mesh;
    mesh.positions = solid.positions;
    constexpr auto kNone = ir::Mesh::kNone;
    for (const auto& f : solid.faces) {
        mesh.faces.push_back(
            {{{{f[0], kNone, kNone}, {f[1], kNone, kNone}, {f[2], kNone, kNone}}}});
    }
    scene.meshes.push_back(std::move(mesh));
    return add(ir::ShapeKind::kMesh, scene.meshes.size() - 1);
}

void SceneMaker::place_last(const std::vector<math::Affined>& object_to_world) {
    scene.objects.back().placement = {static_cast<std::uint32_t>(scene.placements.size()),
                                      static_cast<std::uint32_t>(object_to_world.size())};
    for (const auto& map : object_to_world) {
        const auto inverse = math::inverse(map);
        scene.placements.push_back({map, inverse ? *inverse : math::Affined{}});
    }
}

ir::ObjectId SceneMaker::again(ir::ObjectId object) {
    const ir::Object& old = scene.objects[object.value];
    return add(old.kind, old.shape);
}

math::Affined translation(Vec3d by) {
    math::Affined a;
    for (std::size_t i = 0; i < 3; ++i) a.rows[i][3] = by[i];
    return a;
}

math::Affined scaling(Vec3d by) {
    math::Affined a;
    for (std::size_t i = 0; i < 3; ++i) a.rows[i][i] = by[i];
    return a;
}

math::Affined rotation(Vec3d k, double angle) {
    // Rodrigues' formula.
    const math::SinCos a = math::sincos(angle);
    const double c = 1 - a.cos;
    math::Affined m;
    m.rows[0] = {a.cos + k.x * k.x * c, k.x * k.y * c - k.z * a.sin, k.x * k.z * c + k.y * a.sin,
                 0};
    m.rows[1] = {k.y * k.x * c + k.z * a.sin, a.cos + k.y * k.y * c, k.y * k.z * c - k.x * a.sin,
                 0};
    m.rows[2] = {k.z * k.x * c - k.y * a.sin, k.z * k.y * c + k.x * a.sin, a.cos + k.z * k.z * c,
                 0};
    return m;
}

}  // namespace cobble::test
