// SPDX-License-Identifier: MIT
#include "renderer/shading/light.hpp"

#include "ir/math/elementary.hpp"
#include "renderer/sampling/mappings.hpp"
#include "renderer/shading/frame.hpp"

namespace cobble::renderer {

PreparedLight prepare_light(const ir::Light& light, math::Vec3d scene_origin,
                            std::uint32_t samples) {
    PreparedLight result;
    result.kind = light.kind;
    result.color = light.color;
    if (light.kind == ir::Light::Kind::kPoint) {
        result.position = light.position - scene_origin;
        result.falloff = light.falloff;
        result.radius = light.radius;
    } else {
        result.toward = -light.direction;
        // 1 - cos(a) = 2 sin(a / 2)^2, without cancellation for a small sun.
        const double sine = math::sin(light.angle / 4);
        result.one_minus_cos_half_angle = 2 * sine * sine;
    }
    if (result.has_size()) {
        result.samples = samples;
        result.color = result.color / static_cast<double>(samples);
    }
    return result;
}

template <typename T>
LightSample<T> light_sample(const PreparedLight& light, math::Vec3<T> position, Uniform2 u) {
    if (light.kind == ir::Light::Kind::kPoint) {
        const math::Vec3d way = light.position - position.template to<double>();
        const math::Vec3d axis = math::normalize(way);
        const math::Vec2d disk = sample_disk(u);
        const Frame<double> frame = frame_around(axis);
        const math::Vec3d offset = frame.x * disk.x + frame.y * disk.y;
        return light_place(light, position, light.position + light.radius * offset);
    }
    const math::Vec3d local = sample_cone(u, light.one_minus_cos_half_angle);
    const Frame<double> frame = frame_around(light.toward);
    // The neutral part first: with no angle it is the light's own direction plus zeros.
    const math::Vec3d direction = light.toward * local.z + (frame.x * local.x + frame.y * local.y);
    LightSample<T> result;
    result.direction = direction.template to<T>();
    result.intensity = light.color.template to<T>();
    return result;
}

template LightSample<float> light_sample(const PreparedLight&, math::Vec3<float>, Uniform2);
template LightSample<double> light_sample(const PreparedLight&, math::Vec3<double>, Uniform2);

}  // namespace cobble::renderer
