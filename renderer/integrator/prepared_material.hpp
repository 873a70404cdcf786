// SPDX-License-Identifier: MIT
// Materials as the ray loop reads them, and which surfaces are simple enough for its loops.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/integrator/active_effects.hpp"
#include "renderer/settings.hpp"

namespace cobble::renderer {

/// A material with its assets looked up and switched-off effects taken out.
template <typename T>
struct PreparedMaterial {
    math::Vec3<T> diffuse;
    math::Vec3<T> specular;
    double shininess = 0;
    T refraction_index = 0;  ///< 0: opaque
    const ir::Noise* noise = nullptr;
    const ir::Image* texture = nullptr;
    const ir::Image* normal_map = nullptr;
    const ir::Image* bump_map = nullptr;
    const ir::CubeMap* cube_map = nullptr;
    ir::TextureFilter filter = ir::TextureFilter::kBilinear;
    math::Vec2d texture_scale{1, 1};
    bool error_checker = false;  ///< broken in the file
    bool sends_on = false;       ///< a ray may go on from its surfaces

    [[nodiscard]] bool bends() const { return normal_map != nullptr || bump_map != nullptr; }
    [[nodiscard]] bool reads_uv() const { return texture != nullptr || bends() || error_checker; }
    /// Its surfaces look the same wherever they are hit, but for where they face.
    [[nodiscard]] bool plain() const {
        return !reads_uv() && noise == nullptr && cube_map == nullptr;
    }
};

/// Of the scene, for rays that may take so many turns, and one more for objects without: whatever a
/// broken scene left without a material shows that it is broken.
template <typename T>
std::vector<PreparedMaterial<T>> prepare_materials(const ir::Scene& scene,
                                                   const ActiveEffects& effects,
                                                   std::optional<ir::TextureFilter> filter,
                                                   std::uint32_t bounces);

/// An object at rest, in world space, of a shape that loops over columns compute.
inline bool is_plain_shape(const ir::Scene& scene, const ir::Object& object) {
    if (object.placement.count > 0) return false;
    switch (object.kind) {
        case ir::ShapeKind::kMesh:
        case ir::ShapeKind::kBox:
            return true;
        case ir::ShapeKind::kTriangle:
            return scene.triangles[object.shape].keys.size() == 1;
        case ir::ShapeKind::kSphere:
            return scene.spheres[object.shape].keys.size() == 1;
        case ir::ShapeKind::kPlane:
            break;
    }
    return false;
}

}  // namespace cobble::renderer
