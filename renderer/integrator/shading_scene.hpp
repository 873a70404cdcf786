// SPDX-License-Identifier: MIT
// Everything that the ray loop reads: geometry narrowed to T, camera, lights, materials, and which
// effects are simulated.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/camera/camera.hpp"
#include "renderer/scene/prepared_scene.hpp"
#include "renderer/settings.hpp"
#include "renderer/shading/light.hpp"

namespace cobble::renderer {

/// ir::Effects without its reasons.
struct ActiveEffects {
    bool depth_of_field = false;
    bool motion_blur = false;
    bool soft_shadows = false;
    bool shadows = false;
    bool reflection = false;
    bool refraction = false;
    bool highlights = false;
    bool textures = false;
    bool normal_maps = false;
    bool noise = false;
    bool environment = false;
};

ActiveEffects active_effects(const ir::Effects& effects);

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

    [[nodiscard]] bool reads_uv() const {
        return texture != nullptr || normal_map != nullptr || bump_map != nullptr || error_checker;
    }
};

template <typename T>
PreparedMaterial<T> prepare_material(const ir::Scene& scene, const ir::Material& material,
                                     const ActiveEffects& effects,
                                     std::optional<ir::TextureFilter> filter);

template <typename T>
struct ShadingScene {
    const ir::Scene* source = nullptr;  ///< must outlive this
    ActiveEffects effects;
    std::vector<PreparedMaterial<T>> materials;  ///< and one more, for objects without
    PreparedScene<T> geometry;
    PreparedCamera camera;
    std::vector<PreparedLight> lights;
    math::Vec3<T> ambient;
    math::Vec3<T> background;
    const ir::CubeMap* sky = nullptr;
    std::uint32_t bounces = 0;
    /// Of each object whether it is a see-through body that may touch another in a face; empty if
    /// none is.
    std::vector<std::uint8_t> touching{};

    [[nodiscard]] const PreparedMaterial<T>& material(ir::MaterialId id) const {
        return id.value + std::size_t{1} < materials.size() ? materials[id.value]
                                                            : materials.back();
    }
    /// Whether a ray may go on from a surface of this material.
    [[nodiscard]] bool scatters(const PreparedMaterial<T>& of) const {
        return bounces > 0 && !(of.specular == math::Vec3<T>{}) &&
               (effects.reflection || (effects.refraction && of.refraction_index > T(0)));
    }
    /// Whether any ray goes on from anywhere.
    [[nodiscard]] bool any_scatters() const {
        return std::any_of(materials.begin(), materials.end(),
                           [this](const PreparedMaterial<T>& of) { return scatters(of); });
    }
    /// Bytes of all this, without the source's images.
    [[nodiscard]] std::uint64_t bytes() const;
};

/// Beyond this many turns a path is given up, whatever Settings::bounces says: even a mirror of
/// 99 % sends back less than a ten-thousandth by then, and stacks have a size to be made for.
inline constexpr std::uint32_t kMostBounces = 1000;

/// If `build` is cancelled, returns soon, with what must not be used.
template <typename T>
ShadingScene<T> prepare_shading(const ir::Scene& scene, const Settings& settings,
                                const BuildControl& build = {});

}  // namespace cobble::renderer
