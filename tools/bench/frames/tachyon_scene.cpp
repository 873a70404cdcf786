// SPDX-License-Identifier: MIT
#include "tools/bench/frames/scene_text.hpp"

namespace cobble::bench {

using math::Vec3d;

std::string write_tachyon_scene(const Input& input, const ScenePlan& plan) {
    const ir::Scene& scene = input.scene;
    const ir::Camera& camera = scene.camera;
    // It samples the upper right corners of pixels: turned by half a pixel, it meets their middles.
    const Vec3d forward =
        camera.forward - (camera.right + camera.up) * (half_height(camera) / plan.height);
    // Its cameras look at a mirrored world.
    const auto mirrored = [](Vec3d v) { return words({-v.x, v.y, v.z}); };
    std::string text = "BEGIN_SCENE\n";
    Out out = std::back_inserter(text);
    fmt::format_to(out,
                   "RESOLUTION {} {}\nCAMERA\nZOOM {}\nASPECTRATIO 1.0\nANTIALIASING {}\nRAYDEPTH "
                   "{}\nCENTER {}\nVIEWDIR {}\nUPDIR {}\nEND_CAMERA\n",
                   plan.width, plan.height, 0.5 / half_height(camera), plan.samples - 1,
                   plan.picture.glass ? kGlassBounces : 5, mirrored(camera.center),
                   mirrored(forward), mirrored(camera.up));
    fmt::format_to(out, "LIGHT CENTER {} RAD 0.001 COLOR {}\nBACKGROUND {}\n",
                   mirrored(scene.lights[0].position), words(scene.lights[0].color),
                   words(scene.background.color));
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const ir::Material& m = scene.materials[i];
        if (m.refraction_index > 0) {
            // It bends no rays; these go straight on.
            fmt::format_to(out,
                           "TEXDEF m{} AMBIENT 0 DIFFUSE 0 SPECULAR 0.1 OPACITY 0.1 COLOR 1 1 1 "
                           "TEXFUNC 0\n",
                           i);
        } else {
            fmt::format_to(out,
                           "TEXDEF m{} AMBIENT {} DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR {} TEXFUNC "
                           "0\n",
                           i, scene.background.ambient.x, words(m.diffuse));
        }
    }
    for (const ir::Object& object : scene.objects) {
        const std::string material = fmt::format("m{}", object.material.value);
        switch (object.kind) {
            case ir::ShapeKind::kMesh: {
                const ir::Mesh& mesh = scene.meshes[object.shape];
                for (const auto& face : mesh.faces) {
                    const auto corner = [&](std::size_t i) {
                        return mirrored(mesh.positions[face.corners[i].position]);
                    };
                    fmt::format_to(out, "TRI V0 {} V1 {} V2 {} {}\n", corner(0), corner(2),
                                   corner(1), material);
                }
                break;
            }
            case ir::ShapeKind::kSphere: {
                const auto& key = scene.spheres[object.shape].keys[0];
                fmt::format_to(out, "SPHERE CENTER {} RAD {} {}\n", mirrored(key.center),
                               key.radius, material);
                break;
            }
            case ir::ShapeKind::kBox: {
                const ir::Box& box = scene.boxes[object.shape];
                fmt::format_to(out, "BOX MIN {} MAX {} {}\n",
                               words({-box.max.x, box.min.y, box.min.z}),
                               words({-box.min.x, box.max.y, box.max.z}), material);
                break;
            }
            case ir::ShapeKind::kTriangle:
            case ir::ShapeKind::kPlane:
                break;
        }
    }
    text += "END_SCENE\n";
    std::string path = fmt::format("{}/{}.dat", plan.folder, input.name);
    return write_text(path, text) ? path : "";
}

}  // namespace cobble::bench
