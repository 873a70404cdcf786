// SPDX-License-Identifier: MIT
// Light as it arrives at a point, before anything is in the way.
#pragma once

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/sampling/sobol.hpp"

namespace cobble::renderer {

/// ir::Light, local coordinates (world minus the prepared scene's origin), narrowed where it is
/// used only.
struct PreparedLight {
    ir::Light::Kind kind = ir::Light::Kind::kPoint;
    math::Vec3d position;  ///< kPoint
    math::Vec3d toward;    ///< kDirectional: unit, to the light
    ir::Color color;
    double falloff = 0;
    double radius = 0;
    double one_minus_cos_half_angle = 0;
    std::uint32_t samples = 1;  ///< places on it that a surface asks; `color` is one's part

    [[nodiscard]] bool has_size() const { return radius > 0 || one_minus_cos_half_angle > 0; }
};

/// A light with a size is asked at `samples` places, at least 1.
PreparedLight prepare_light(const ir::Light& light, math::Vec3d scene_origin,
                            std::uint32_t samples = 1);

template <typename T>
struct LightSample {
    math::Vec3<T> direction;  ///< unit, to the light; zero if the point is in it
    math::Vec3<T> target;     ///< kPoint: the place on the light, local
    math::Vec3<T> intensity;  ///< color / (1 + falloff d^2)
};

/// A point light's, seen from a place on it (in double, local).
template <typename T>
LightSample<T> light_place(const PreparedLight& light, math::Vec3<T> position, math::Vec3d place) {
    LightSample<T> result;
    result.target = place.template to<T>();
    const math::Vec3d way = place - position.template to<double>();
    result.direction = math::normalize(way).template to<T>();
    // What a division by 1 gives.
    const ir::Color color =
        light.falloff == 0 ? light.color : light.color / (1 + light.falloff * math::dot(way, way));
    result.intensity = color.template to<T>();
    return result;
}

/// The light from its middle.
template <typename T>
LightSample<T> light_middle(const PreparedLight& light, math::Vec3<T> position) {
    if (light.kind == ir::Light::Kind::kPoint) return light_place(light, position, light.position);
    LightSample<T> result;
    result.direction = light.toward.template to<T>();
    result.intensity = light.color.template to<T>();
    return result;
}

/// From a place on it: a point light with a radius is a disk of that radius that faces `position`;
/// a directional light with an angle is the cone of directions within half of it, uniform in solid
/// angle. A light without size gives the bits of light_middle().
template <typename T>
LightSample<T> light_sample(const PreparedLight& light, math::Vec3<T> position, Uniform2 u);

}  // namespace cobble::renderer
