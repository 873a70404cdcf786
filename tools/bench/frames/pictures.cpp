// SPDX-License-Identifier: MIT
#include "tools/bench/frames/pictures.hpp"

#include "ir/math/elementary.hpp"
#include "tools/bench/inputs/random.hpp"

namespace cobble::bench {

using math::Vec3d;

namespace {

/// A grid of glass balls before matt ones, on a floor of two triangles.
Input glass_input() {
    Input input;
    input.title = "36 balls of glass, 49 matt ones, a floor";
    input.scene = empty_scene({4, 9, 6});
    aim_camera(input.scene, {0, 4.2, 9.5}, {0, 0.9, 0}, 40 * math::kPi / 180);
    ir::Material glass;
    glass.diffuse = {0, 0, 0};
    glass.specular = {1, 1, 1};
    glass.refraction_index = 1.5;
    input.scene.materials.push_back(glass);
    const auto ball = [&](Vec3d at, double radius, std::uint32_t material) {
        input.scene.spheres.push_back({{{at, radius}}});
        add_object(input.scene, ir::ShapeKind::kSphere, input.scene.spheres.size() - 1);
        input.scene.objects.back().material = ir::MaterialId{material};
    };
    for (int z = 0; z < 6; ++z) {
        for (int x = 0; x < 6; ++x) ball({1.1 * x - 2.75, 0.6, 4 - 1.1 * z}, 0.5, 1);
    }
    for (int y = 0; y < 7; ++y) {
        for (int x = 0; x < 7; ++x) ball({1.2 * x - 3.6, 0.5 + 0.9 * y, -4}, 0.4, 0);
    }
    ir::Mesh floor;
    floor.positions = {{-12, 0, -12}, {12, 0, -12}, {12, 0, 12}, {-12, 0, 12}};
    add_face(floor, 0, 3, 2);
    add_face(floor, 0, 2, 1);
    input.scene.meshes.push_back(std::move(floor));
    add_object(input.scene, ir::ShapeKind::kMesh, 0);
    return input;
}

}  // namespace

const std::vector<PictureName>& picture_names() {
    static const std::vector<PictureName> names{
        {"mesh", "a mesh of 70,000 triangles"},
        {"boxes", "240,000 blocks as boxes"},
        {"blocks", "the same blocks as triangles"},
        {"spheres", "10,000 spheres"},
        {"glass", "balls of glass, to depth 8, without shadows", true},
    };
    return names;
}

Input make_picture(std::string_view name) {
    Input input = name == "mesh"     ? mesh_input(70'000)
                  : name == "boxes"  ? block_input(true)
                  : name == "blocks" ? block_input(false)
                  : name == "glass"  ? glass_input()
                                     : sphere_input(10'000);
    input.name = name;
    return input;
}

}  // namespace cobble::bench
