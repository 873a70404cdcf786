// SPDX-License-Identifier: MIT
#include "renderer/integrator/shading_scene.hpp"

#include <algorithm>

#include "renderer/integrator/seams.hpp"

namespace cobble::renderer {

ActiveEffects active_effects(const ir::Effects& effects) {
    using ir::Effect;
    ActiveEffects result;
    result.depth_of_field = effects.on(Effect::kDepthOfField);
    result.motion_blur = effects.on(Effect::kMotionBlur);
    result.soft_shadows = effects.on(Effect::kSoftShadows);
    result.shadows = effects.on(Effect::kShadows);
    result.reflection = effects.on(Effect::kReflection);
    result.refraction = effects.on(Effect::kRefraction);
    result.highlights = effects.on(Effect::kHighlights);
    result.textures = effects.on(Effect::kTextures);
    result.normal_maps = effects.on(Effect::kNormalMaps);
    result.noise = effects.on(Effect::kNoise);
    result.environment = effects.on(Effect::kEnvironment);
    return result;
}

template <typename T>
PreparedMaterial<T> prepare_material(const ir::Scene& scene, const ir::Material& material,
                                     const ActiveEffects& effects,
                                     std::optional<ir::TextureFilter> filter) {
    const auto image = [&](ir::ImageId id, bool wanted) {
        return wanted && id.valid() ? &scene.images[id.value] : nullptr;
    };
    PreparedMaterial<T> result;
    result.diffuse = material.diffuse.template to<T>();
    result.specular = material.specular.template to<T>();
    result.shininess = material.shininess;
    result.refraction_index = static_cast<T>(material.refraction_index);
    if (effects.noise && material.has_noise) result.noise = &material.noise;
    if (result.noise == nullptr) result.texture = image(material.texture, effects.textures);
    result.normal_map = image(material.normal_map, effects.normal_maps);
    result.bump_map = image(material.bump_map, effects.normal_maps);
    if (effects.environment && material.cube_map.valid()) {
        result.cube_map = &scene.cube_maps[material.cube_map.value];
    }
    result.filter = filter.value_or(material.texture_filter);
    result.texture_scale = material.texture_scale;
    result.error_checker = material.substituted;
    return result;
}

template <typename T>
std::uint64_t ShadingScene<T>::bytes() const {
    return geometry.bytes() + materials.size() * sizeof(PreparedMaterial<T>) +
           lights.size() * sizeof(PreparedLight) + touching.size();
}

template <typename T>
ShadingScene<T> prepare_shading(const ir::Scene& scene, const Settings& settings,
                                const BuildControl& build) {
    const ActiveEffects effects = active_effects(settings.effects);
    std::vector<PreparedMaterial<T>> materials;
    materials.reserve(scene.materials.size() + 1);
    bool reads_uv = false;
    for (const ir::Material& material : scene.materials) {
        materials.push_back(prepare_material<T>(scene, material, effects, settings.texture_filter));
        reads_uv = reads_uv || materials.back().reads_uv();
    }
    // Whatever a broken scene left without a material shows that it is broken.
    ir::Material broken;
    broken.substituted = true;
    materials.push_back(prepare_material<T>(scene, broken, effects, settings.texture_filter));
    PrepareOptions options;
    options.acceleration = settings.acceleration;
    options.texture_coordinates = reads_uv;
    options.build = build;
    ShadingScene<T> result{&scene,
                           effects,
                           std::move(materials),
                           prepare<T>(scene, options),
                           PreparedCamera(scene.camera, settings.width, settings.height),
                           {},
                           scene.background.ambient.template to<T>(),
                           scene.background.color.template to<T>(),
                           nullptr,
                           std::min(settings.bounces, kMostBounces)};
    result.lights.reserve(scene.lights.size());
    const std::uint32_t light_samples =
        effects.soft_shadows ? std::max(settings.light_samples, 1U) : 1;
    for (const ir::Light& light : scene.lights) {
        result.lights.push_back(prepare_light(light, result.geometry.origin, light_samples));
    }
    if (effects.environment && scene.background.cube_map.valid()) {
        result.sky = &scene.cube_maps[scene.background.cube_map.value];
    }
    if (effects.refraction) result.touching = touching_bodies(result);
    return result;
}

template struct ShadingScene<float>;
template struct ShadingScene<double>;
template PreparedMaterial<float> prepare_material(const ir::Scene&, const ir::Material&,
                                                  const ActiveEffects&,
                                                  std::optional<ir::TextureFilter>);
template PreparedMaterial<double> prepare_material(const ir::Scene&, const ir::Material&,
                                                   const ActiveEffects&,
                                                   std::optional<ir::TextureFilter>);
template ShadingScene<float> prepare_shading(const ir::Scene&, const Settings&,
                                             const BuildControl&);
template ShadingScene<double> prepare_shading(const ir::Scene&, const Settings&,
                                              const BuildControl&);

}  // namespace cobble::renderer
