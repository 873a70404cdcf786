// SPDX-License-Identifier: MIT
#include "tools/bench/frames/scene_text.hpp"

namespace cobble::bench {

using math::Vec3d;

std::string write_povray_scene(const Input& input, const ScenePlan& plan) {
    const ir::Scene& scene = input.scene;
    const ir::Camera& camera = scene.camera;
    std::string text;
    Out out = std::back_inserter(text);
    // One level is the camera's ray; no branch ends early for being faint, as none of ours does.
    fmt::format_to(out,
                   "#version 3.7;\nglobal_settings {{ assumed_gamma 1 max_trace_level {} "
                   "adc_bailout 0 }}\n",
                   plan.picture.glass ? kGlassBounces + 1 : 5);
    const double h = half_height(camera);
    fmt::format_to(out, "camera {{ location {} direction {} right {} up {} }}\n",
                   pointed(camera.center), pointed(camera.forward),
                   pointed(camera.right * (2 * h * plan.width / plan.height)),
                   pointed(camera.up * (2 * h)));
    fmt::format_to(out, "light_source {{ {} rgb {} {} }}\n", pointed(scene.lights[0].position),
                   pointed(scene.lights[0].color), plan.picture.glass ? "shadowless" : "");
    fmt::format_to(out, "background {{ rgb {} }}\n", pointed(scene.background.color));
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const ir::Material& m = scene.materials[i];
        if (m.refraction_index > 0) {
            // `material` takes an interior; Fresnel's mirror takes from what is let through.
            fmt::format_to(
                out,
                "#declare M{} = material {{ texture {{ pigment {{ rgbf 1 }} finish {{ ambient 0 "
                "diffuse 0 reflection {{ 0 1 fresnel on }} conserve_energy }} }} "
                "interior {{ ior {} }} }}\n",
                i, m.refraction_index);
        } else {
            fmt::format_to(out,
                           "#declare M{} = material {{ texture {{ pigment {{ rgb {} }} finish {{ "
                           "ambient rgb {} diffuse 1 }} }} }}\n",
                           i, pointed(m.diffuse), pointed(scene.background.ambient));
        }
    }
    for (const ir::Object& object : scene.objects) {
        const std::string material = fmt::format("material {{ M{} }}", object.material.value);
        switch (object.kind) {
            case ir::ShapeKind::kMesh: {
                const ir::Mesh& mesh = scene.meshes[object.shape];
                fmt::format_to(out, "mesh2 {{ vertex_vectors {{ {}\n", mesh.positions.size());
                for (const Vec3d& p : mesh.positions) fmt::format_to(out, ",{}\n", pointed(p));
                fmt::format_to(out, "}} face_indices {{ {}\n", mesh.faces.size());
                for (const auto& face : mesh.faces) {
                    const auto& c = face.corners;
                    fmt::format_to(out, ",<{},{},{}>\n", c[0].position, c[1].position,
                                   c[2].position);
                }
                fmt::format_to(out, "}} {} }}\n", material);
                break;
            }
            case ir::ShapeKind::kSphere: {
                const auto& key = scene.spheres[object.shape].keys[0];
                fmt::format_to(out, "sphere {{ {} {} {} }}\n", pointed(key.center), key.radius,
                               material);
                break;
            }
            case ir::ShapeKind::kBox: {
                const ir::Box& box = scene.boxes[object.shape];
                fmt::format_to(out, "box {{ {} {} {} }}\n", pointed(box.min), pointed(box.max),
                               material);
                break;
            }
            case ir::ShapeKind::kTriangle:
            case ir::ShapeKind::kPlane:
                break;
        }
    }
    std::string path = fmt::format("{}/{}.pov", plan.folder, input.name);
    return write_text(path, text) ? path : "";
}

}  // namespace cobble::bench
