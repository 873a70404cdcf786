// SPDX-License-Identifier: MIT
#include "ir/lower/fold.hpp"

#include <algorithm>

namespace cobble::ir {

bool has_uv_everywhere(const Scene& scene, const Object& object) {
    if (object.kind == ShapeKind::kTriangle) return false;
    if (object.kind != ShapeKind::kMesh) return true;
    const auto& faces = scene.meshes[object.shape].faces;
    return std::all_of(faces.begin(), faces.end(),
                       [](const Mesh::Face& face) { return face.corners[0].uv != Mesh::kNone; });
}

bool has_uv_somewhere(const Scene& scene, const Object& object) {
    if (object.kind == ShapeKind::kTriangle) return false;
    if (object.kind != ShapeKind::kMesh) return true;
    const auto& faces = scene.meshes[object.shape].faces;
    return std::any_of(faces.begin(), faces.end(),
                       [](const Mesh::Face& face) { return face.corners[0].uv != Mesh::kNone; });
}

void fold_constants(Scene& scene) {
    if (scene.compat != Compat::kNone) return;
    // Per mesh, not per object: many objects share one.
    std::vector<signed char> mesh_uv(scene.meshes.size(), -1);
    std::vector<bool> everywhere(scene.materials.size(), true);
    for (const Object& object : scene.objects) {
        bool uv = false;
        if (object.kind == ShapeKind::kMesh) {
            auto& known = mesh_uv[object.shape];
            if (known < 0) known = has_uv_everywhere(scene, object) ? 1 : 0;
            uv = known == 1;
        } else {
            uv = has_uv_everywhere(scene, object);
        }
        if (!uv) everywhere[object.material.value] = false;
    }
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        Material& material = scene.materials[i];
        if (material.has_noise) {
            // The noise hides the texture.
            if (material.noise.color1 != material.noise.color2) continue;
            material.diffuse = material.noise.color1;
            material.has_noise = false;
            material.noise = {};
            material.texture = {};
            continue;
        }
        if (!material.texture.valid() || !everywhere[i]) continue;
        const Image& image = scene.images[material.texture.value];
        if (!image.constant) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            material.diffuse[k] =
                image.bytes.empty() ? static_cast<double>(image.floats[k]) : image.bytes[k] / 255.0;
        }
        material.folded_texture = material.texture;
        material.texture = {};
    }
}

}  // namespace cobble::ir
