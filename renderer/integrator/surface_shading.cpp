// SPDX-License-Identifier: MIT
#include "renderer/integrator/surface_shading.hpp"

#include "renderer/shading/fresnel.hpp"
#include "renderer/shading/noise.hpp"
#include "renderer/shading/normal_map.hpp"
#include "renderer/shading/texture.hpp"

namespace cobble::renderer {
namespace {

template <typename T>
math::Vec2d texture_point(const PreparedMaterial<T>& material, const SurfacePoint<T>& point) {
    return {static_cast<double>(point.uv.x) * material.texture_scale.x,
            static_cast<double>(point.uv.y) * material.texture_scale.y};
}

template <typename T>
math::Vec3<T> base_color(const ShadingScene<T>& scene, const PreparedMaterial<T>& material,
                         const SurfacePoint<T>& point) {
    if (material.error_checker) {
        return (point.has_uv ? error_checker(texture_point(material, point)) : kErrorColor)
            .template to<T>();
    }
    if (material.noise != nullptr) {
        const math::Vec3d world = scene.geometry.to_world(point.position);
        return marble_color(*material.noise, world).template to<T>();
    }
    if (material.texture != nullptr && point.has_uv) {
        return sample_texture(*material.texture, material.filter, texture_point(material, point))
            .template to<T>();
    }
    return material.diffuse;
}

/// The shading normal, bent by the material's maps.
template <typename T>
math::Vec3<T> bent_normal(const PreparedMaterial<T>& material, const SurfacePoint<T>& point) {
    const math::Vec2d uv = texture_point(material, point);
    math::Vec3d tangent_space{0, 0, 1};
    if (material.normal_map != nullptr) {
        tangent_space = mapped_normal(*material.normal_map, material.filter, uv);
    }
    if (material.bump_map != nullptr) {
        const math::Vec2d slope = bump_slope(*material.bump_map, material.filter, uv);
        tangent_space.x -= slope.x * tangent_space.z;
        tangent_space.y -= slope.y * tangent_space.z;
    }
    // A negative scale mirrors the picture, and with it the way its coordinates grow.
    const T u_sign = material.texture_scale.x < 0 ? T(-1) : T(1);
    const T v_sign = material.texture_scale.y < 0 ? T(-1) : T(1);
    return bend_normal(point.shading_normal, point.dp_du * u_sign, point.dp_dv * v_sign,
                       tangent_space);
}

}  // namespace

template <typename T>
SurfaceLook<T> look_at_surface(const ShadingScene<T>& scene, const PreparedMaterial<T>& material,
                               const SurfacePoint<T>& point, math::Vec3<T> direction) {
    SurfaceLook<T> look;
    look.kd = base_color(scene, material, point);
    look.leaving = math::dot(direction, point.geometric_normal) > T(0);

    math::Vec3<T> normal = point.shading_normal;
    if ((material.normal_map != nullptr || material.bump_map != nullptr) && point.has_uv) {
        normal = bent_normal(material, point);
        look.bent = !(normal == point.shading_normal);
    }
    const bool closed = point.kind == ir::ShapeKind::kSphere || point.kind == ir::ShapeKind::kBox;
    const bool flip = look.leaving && !closed;
    look.normal = flip ? -normal : normal;
    look.smooth = flip ? -point.shading_normal : point.shading_normal;
    look.geometric = flip ? -point.geometric_normal : point.geometric_normal;
    look.viewer_geometric = look.leaving ? -point.geometric_normal : point.geometric_normal;
    look.viewer_normal = facing(look.leaving ? -normal : normal, look.viewer_geometric, direction);
    return look;
}

template SurfaceLook<float> look_at_surface(const ShadingScene<float>&,
                                            const PreparedMaterial<float>&,
                                            const SurfacePoint<float>&, math::Vec3<float>);
template SurfaceLook<double> look_at_surface(const ShadingScene<double>&,
                                             const PreparedMaterial<double>&,
                                             const SurfacePoint<double>&, math::Vec3<double>);

}  // namespace cobble::renderer
