// SPDX-License-Identifier: MIT
#include "renderer/integrator/prepared_material.hpp"

namespace cobble::renderer {
namespace {

template <typename T>
PreparedMaterial<T> prepare_material(const ir::Scene& scene, const ir::Material& material,
                                     const ActiveEffects& effects,
                                     std::optional<ir::TextureFilter> filter,
                                     std::uint32_t bounces) {
    const auto image = [&](ir::ImageId id, bool wanted) {
        return wanted && id.valid() ? &scene.images[id.value] : nullptr;
    };
    PreparedMaterial<T> result;
    result.diffuse = material.diffuse.template to<T>();
    result.specular = material.specular.template to<T>();
    result.shininess = effects.highlights() ? material.shininess : 0;
    result.refraction_index = static_cast<T>(material.refraction_index);
    if (effects.noise() && material.has_noise) result.noise = &material.noise;
    if (result.noise == nullptr) result.texture = image(material.texture, effects.textures());
    result.normal_map = image(material.normal_map, effects.normal_maps());
    result.bump_map = image(material.bump_map, effects.normal_maps());
    if (effects.environment() && material.cube_map.valid()) {
        result.cube_map = &scene.cube_maps[material.cube_map.value];
    }
    result.filter = filter.value_or(material.texture_filter);
    result.texture_scale = material.texture_scale;
    result.error_checker = material.substituted;
    result.sends_on =
        bounces > 0 && !(result.specular == math::Vec3<T>{}) &&
        (effects.reflection() || (effects.refraction() && result.refraction_index > T(0)));
    return result;
}

}  // namespace

template <typename T>
std::vector<PreparedMaterial<T>> prepare_materials(const ir::Scene& scene,
                                                   const ActiveEffects& effects,
                                                   std::optional<ir::TextureFilter> filter,
                                                   std::uint32_t bounces) {
    std::vector<PreparedMaterial<T>> materials;
    materials.reserve(scene.materials.size() + 1);
    for (const ir::Material& material : scene.materials) {
        materials.push_back(prepare_material<T>(scene, material, effects, filter, bounces));
    }
    ir::Material broken;
    broken.substituted = true;
    materials.push_back(prepare_material<T>(scene, broken, effects, filter, bounces));
    return materials;
}

template std::vector<PreparedMaterial<float>> prepare_materials(const ir::Scene&,
                                                                const ActiveEffects&,
                                                                std::optional<ir::TextureFilter>,
                                                                std::uint32_t);
template std::vector<PreparedMaterial<double>> prepare_materials(const ir::Scene&,
                                                                 const ActiveEffects&,
                                                                 std::optional<ir::TextureFilter>,
                                                                 std::uint32_t);

}  // namespace cobble::renderer
