// SPDX-License-Identifier: MIT
#include "tools/bench/frames/scene_text.hpp"

namespace cobble::bench {

using math::Vec3d;

std::string write_cobble_scene(const Input& input, const ScenePlan& plan) {
    const ir::Scene& scene = input.scene;
    std::string text;
    Out out = std::back_inserter(text);
    fmt::format_to(out,
                   "PerspectiveCamera {{\n    center {}\n    direction {}\n    up {}\n    angle "
                   "{}\n}}\n\n",
                   words(scene.camera.center), words(scene.camera.forward),
                   words(scene.camera.up_as_written), scene.camera.angle * 180 / math::kPi);
    fmt::format_to(
        out, "Lights {{\n    PointLight {{\n        position {}\n        color {}\n    }}\n}}\n\n",
        words(scene.lights[0].position), words(scene.lights[0].color));
    fmt::format_to(out, "Background {{\n    color {}\n    ambientLight {}\n}}\n\nMaterials {{\n",
                   words(scene.background.color), words(scene.background.ambient));
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const ir::Material& m = scene.materials[i];
        fmt::format_to(out, "    PhongMaterial m{} {{\n        diffuseColor {}\n", i,
                       words(m.diffuse));
        if (m.refraction_index > 0) {
            fmt::format_to(out, "        specularColor {}\n        refractionIndex {}\n",
                           words(m.specular), m.refraction_index);
        }
        text += "    }\n";
    }
    text += "}\n\nGroup {\n";
    std::uint32_t material = ir::MaterialId::kNone;
    for (const ir::Object& object : scene.objects) {
        if (object.material.value != material) {
            material = object.material.value;
            fmt::format_to(out, "    MaterialIndex m{}\n", material);
        }
        switch (object.kind) {
            case ir::ShapeKind::kMesh: {
                const ir::Mesh& mesh = scene.meshes[object.shape];
                const std::string name = fmt::format("{}_{}.obj", input.name, object.shape);
                std::string obj;
                Out to = std::back_inserter(obj);
                for (const Vec3d& p : mesh.positions) fmt::format_to(to, "v {}\n", words(p));
                for (const auto& face : mesh.faces) {
                    const auto& c = face.corners;
                    fmt::format_to(to, "f {} {} {}\n", c[0].position + 1, c[1].position + 1,
                                   c[2].position + 1);
                }
                if (!write_text(plan.folder + "/" + name, obj)) return "";
                fmt::format_to(
                    out,
                    "    TriangleMesh {{\n        obj_file {}\n        creaseAngle 0\n    }}\n",
                    name);
                break;
            }
            case ir::ShapeKind::kSphere: {
                const auto& key = scene.spheres[object.shape].keys[0];
                fmt::format_to(out, "    Sphere {{\n        center {}\n        radius {}\n    }}\n",
                               words(key.center), key.radius);
                break;
            }
            case ir::ShapeKind::kBox: {
                const ir::Box& box = scene.boxes[object.shape];
                fmt::format_to(out, "    Box {{\n        min {}\n        max {}\n    }}\n",
                               words(box.min), words(box.max));
                break;
            }
            case ir::ShapeKind::kTriangle:
            case ir::ShapeKind::kPlane:
                break;
        }
    }
    text += "}\n";
    std::string path = fmt::format("{}/{}.scene", plan.folder, input.name);
    return write_text(path, text) ? path : "";
}

}  // namespace cobble::bench
