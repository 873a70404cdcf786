// SPDX-License-Identifier: MIT
#include "tools/bench/frames/scene_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "ir/math/elementary.hpp"

namespace cobble::bench {

using math::Vec3d;

namespace {

using Out = std::back_insert_iterator<std::string>;

/// "x y z", as short as reads back the same.
std::string words(Vec3d v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
/// "<x,y,z>"
std::string pointed(Vec3d v) { return fmt::format("<{},{},{}>", v.x, v.y, v.z); }

/// Height of the picture's half at distance 1.
double half_height(const ir::Camera& camera) {
    const auto half = math::sincos(camera.angle / 2);
    return half.sin / half.cos;
}

}  // namespace

bool write_text(const std::string& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    return bool(file);
}

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
