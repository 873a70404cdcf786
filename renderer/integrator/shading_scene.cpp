// SPDX-License-Identifier: MIT
#include "renderer/integrator/shading_scene.hpp"

#include <utility>

#include "renderer/integrator/seams.hpp"

namespace cobble::renderer {
namespace {

/// Without what effects that are off would read: to a stage that asks all the same they are at
/// their neutral parameter.
ir::Camera neutral_camera(ir::Camera camera, const ActiveEffects& effects) {
    if (!effects.depth_of_field()) camera.aperture = 0;
    if (!effects.motion_blur()) camera.shutter_close = camera.shutter_open;
    return camera;
}

}  // namespace

template <typename T>
std::uint64_t ShadingScene<T>::bytes() const {
    return geometry.bytes() + materials.size() * sizeof(PreparedMaterial<T>) +
           lights.size() * sizeof(PreparedLight) + touching.size();
}

template <typename T>
ShadingScene<T> prepare_shading(const ir::Scene& scene, const Settings& settings,
                                const BuildControl& build) {
    const ActiveEffects effects(settings.effects);
    std::vector<PreparedMaterial<T>> materials =
        prepare_materials<T>(scene, effects, settings.texture_filter, settings.bounces);
    RenderPlan plan = make_plan<T>(scene, settings, materials);
    PrepareOptions options;
    options.acceleration = settings.acceleration;
    options.texture_coordinates = plan.reads_uv;
    options.build = build;
    const std::uint32_t bounces = plan.bounces;
    ShadingScene<T> result{
        &scene,
        effects,
        std::move(plan),
        std::move(materials),
        prepare<T>(scene, options),
        PreparedCamera(neutral_camera(scene.camera, effects), settings.width, settings.height),
        {},
        scene.background.ambient.template to<T>(),
        scene.background.color.template to<T>(),
        nullptr,
        bounces};
    result.lights.reserve(scene.lights.size());
    const std::uint32_t light_samples =
        effects.soft_shadows() ? std::max(settings.light_samples, 1U) : 1;
    for (const ir::Light& light : scene.lights) {
        PreparedLight& prepared =
            result.lights.emplace_back(prepare_light(light, result.geometry.origin, light_samples));
        if (!effects.soft_shadows()) prepared.radius = prepared.one_minus_cos_half_angle = 0;
    }
    if (effects.environment() && scene.background.cube_map.valid()) {
        result.sky = &scene.cube_maps[scene.background.cube_map.value];
    }
    if (effects.refraction()) result.touching = touching_bodies(result);
    return result;
}

template struct ShadingScene<float>;
template struct ShadingScene<double>;
template ShadingScene<float> prepare_shading(const ir::Scene&, const Settings&,
                                             const BuildControl&);
template ShadingScene<double> prepare_shading(const ir::Scene&, const Settings&,
                                              const BuildControl&);

}  // namespace cobble::renderer
