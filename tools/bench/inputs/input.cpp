// SPDX-License-Identifier: MIT
#include "tools/bench/inputs/input.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <utility>

#include "ir/assets/obj/obj_file.hpp"
#include "ir/math/elementary.hpp"

namespace cobble::bench {

using math::Vec3d;

const std::vector<InputName>& input_names() {
    static const std::vector<InputName> names{
        {"spheres", "10,000 spheres"},
        {"mesh-70k", "a mesh of 70,000 triangles"},
        {"mesh-1m", "a mesh of a million triangles"},
        {"boxes", "250,000 blocks as boxes; peers get the triangles"},
        {"blocks", "the same blocks as triangles"},
        {"forest", "a tree placed 10,000 times"},
        {"mesh-10m", "a mesh of ten million triangles", true},
    };
    return names;
}

Input make_input(std::string_view name) {
    Input input = name == "spheres"    ? sphere_input(10'000)
                  : name == "mesh-70k" ? mesh_input(70'000)
                  : name == "mesh-1m"  ? mesh_input(1'000'000)
                  : name == "mesh-10m" ? mesh_input(10'000'000)
                  : name == "boxes"    ? block_input(true)
                  : name == "blocks"   ? block_input(false)
                                       : forest_input(10'000);
    input.name = name;
    return input;
}

void aim_camera(ir::Scene& scene, Vec3d eye, Vec3d target, double angle) {
    ir::Camera& camera = scene.camera;
    camera.center = eye;
    camera.forward = normalize(target - eye);
    camera.up_as_written = {0, 1, 0};
    camera.right = normalize(cross(camera.forward, camera.up_as_written));
    camera.up = cross(camera.right, camera.forward);
    camera.angle = angle;
}

ir::Scene empty_scene(Vec3d light) {
    ir::Scene scene;
    ir::Material material;
    material.diffuse = {0.8, 0.8, 0.8};
    scene.materials.push_back(material);
    ir::Light point;
    point.position = light;
    point.color = {1, 1, 1};
    scene.lights.push_back(point);
    scene.background.color = {0.4, 0.6, 0.9};
    scene.background.ambient = {0.2, 0.2, 0.2};
    return scene;
}

void add_object(ir::Scene& scene, ir::ShapeKind kind, std::size_t shape) {
    ir::Object object;
    object.kind = kind;
    object.shape = static_cast<std::uint32_t>(shape);
    object.material = ir::MaterialId{0};
    scene.objects.push_back(object);
}

void add_face(ir::Mesh& mesh, std::size_t a, std::size_t b, std::size_t c) {
    constexpr auto kNone = ir::Mesh::kNone;
    const auto corner = [](std::size_t i) {
        return ir::Mesh::Corner{static_cast<std::uint32_t>(i), kNone, kNone};
    };
    mesh.faces.push_back({{{corner(a), corner(b), corner(c)}}});
}

std::size_t stored_primitives(const ir::Scene& scene) {
    std::size_t sum = scene.spheres.size() + scene.boxes.size() + scene.triangles.size();
    for (const ir::Mesh& mesh : scene.meshes) sum += mesh.faces.size();
    return sum;
}

std::optional<Input> read_input(const std::string& path, std::string& problem) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file) {
        problem = fmt::format("cannot read {}", path);
        return {};
    }
    ir::ObjFile obj =
        ir::read_obj(text, ir::ObjRules::kStandard, std::numeric_limits<std::uint32_t>::max());
    if (obj.faces.empty()) {
        problem = fmt::format("{} holds no face", path);
        return {};
    }
    Vec3d low = obj.positions[obj.faces[0].corners[0].position];
    Vec3d high = low;
    for (ir::Mesh::Face& face : obj.faces) {
        for (auto& corner : face.corners) {
            corner.normal = corner.uv = ir::Mesh::kNone;
            const Vec3d p = obj.positions[corner.position];
            for (std::size_t a = 0; a < 3; ++a) {
                low[a] = p[a] < low[a] ? p[a] : low[a];
                high[a] = p[a] > high[a] ? p[a] : high[a];
            }
        }
    }
    const Vec3d middle = (low + high) * 0.5;
    const double size = length(high - low);

    Input input;
    input.name = "obj";
    input.title = fmt::format("{}, {} triangles", path, obj.faces.size());
    input.scene = empty_scene(middle + Vec3d{0.8, 1.2, 0.9} * size);
    // From here and at this angle the sphere around the box just fits: asin(0.5 / 1.4) is 21
    // degrees.
    aim_camera(input.scene, middle + normalize(Vec3d{0.3, 0.35, 1}) * (1.4 * size), middle,
               42 * math::kPi / 180);
    ir::Mesh mesh;
    mesh.positions = std::move(obj.positions);
    mesh.faces = std::move(obj.faces);
    input.scene.meshes.push_back(std::move(mesh));
    add_object(input.scene, ir::ShapeKind::kMesh, 0);
    return input;
}

}  // namespace cobble::bench
