// SPDX-License-Identifier: MIT
#include "tests/compat/small_scene.hpp"

#include "renderer/film/picture.hpp"
#include "tests/compat/support.hpp"

namespace cobble::test {
namespace {

void add_object(ir::Scene& scene, ir::ShapeKind kind, std::size_t shape, std::uint32_t material) {
    ir::Object object;
    object.kind = kind;
    object.shape = static_cast<std::uint32_t>(shape);
    object.material = {material};
    scene.objects.push_back(object);
}

}  // namespace

ir::Scene plain_scene(ir::Compat compat) {
    ir::Scene scene;
    scene.compat = compat;
    scene.camera.center = {0, 0, 5};
    scene.camera.forward = {0, 0, -1};
    scene.camera.up = {0, 1, 0};
    scene.camera.up_as_written = {0, 1, 0};
    scene.camera.right = {1, 0, 0};
    scene.camera.angle = 1.5707963267948966;
    scene.background.color = {0, 0, 1};
    ir::Light light;
    light.kind = ir::Light::Kind::kDirectional;
    light.direction = {0, 0, -1};
    light.color = {1, 1, 1};
    scene.lights.push_back(light);
    ir::Material material;
    material.diffuse = {0.5, 0.25, 0.125};
    scene.materials.push_back(material);
    return scene;
}

void add_wall(ir::Scene& scene, double z, std::uint32_t material, double facing) {
    ir::Plane plane;
    plane.normal = {0, 0, facing};
    plane.offset = z * facing;
    add_plane(scene, plane, material);
}

void add_plane(ir::Scene& scene, const ir::Plane& plane, std::uint32_t material) {
    add_object(scene, ir::ShapeKind::kPlane, scene.planes.size(), material);
    scene.planes.push_back(plane);
}

void add_ball(ir::Scene& scene, math::Vec3d center, double radius, std::uint32_t material) {
    add_object(scene, ir::ShapeKind::kSphere, scene.spheres.size(), material);
    scene.spheres.push_back({{{center, radius}}});
}

renderer::Settings sized(std::uint32_t width, std::uint32_t height) {
    renderer::Settings settings;
    settings.width = width;
    settings.height = height;
    settings.compat.casting = true;
    return settings;
}

ir::Color middle(const ir::Scene& scene, renderer::Settings settings) {
    settings.width = settings.height = 3;
    const renderer::Plane32 color = render(scene, settings, 1).color;
    return {static_cast<double>(color.at(1, 1, 0)), static_cast<double>(color.at(1, 1, 1)),
            static_cast<double>(color.at(1, 1, 2))};
}

double red(const ir::Scene& scene, const renderer::Settings& settings) {
    return middle(scene, settings).x;
}

void add_picture_frame(ir::Scene& scene, std::uint32_t material) {
    ir::Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    constexpr std::uint32_t kFlat = ir::Mesh::kNone;
    mesh.faces = {{{{{0, kFlat, 0}, {1, kFlat, 1}, {2, kFlat, 2}}}},
                  {{{{0, kFlat, 0}, {2, kFlat, 2}, {3, kFlat, 3}}}}};
    mesh.face_offsets = {0, 0};
    add_object(scene, ir::ShapeKind::kMesh, scene.meshes.size(), material);
    scene.meshes.push_back(mesh);
}

ir::ImageId add_dot(ir::Scene& scene, std::uint8_t r, std::uint8_t g, std::uint8_t b) {
    ir::Image image;
    image.width = image.height = 1;
    image.bytes = {r, g, b};
    scene.images.push_back(image);
    return {static_cast<std::uint32_t>(scene.images.size() - 1)};
}

}  // namespace cobble::test
