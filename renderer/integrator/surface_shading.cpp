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

/// A material is of a broken file, or noise, or a picture: each only if there are any.
template <SurfaceStage kStage, typename T>
math::Vec3<T> base_color(const ShadingScene<T>& scene, const PreparedMaterial<T>& material,
                         const SurfacePoint<T>& point, Counters& counters) {
    if (material.error_checker) {
        return (point.has_uv ? error_checker(texture_point(material, point)) : kErrorColor)
            .template to<T>();
    }
    if constexpr ((kStage & kSurfaceNoise) != 0 && compiled_in(ir::Effect::kNoise)) {
        if (material.noise != nullptr) {
            ++counters.noise_evaluations;
            const math::Vec3d world = scene.geometry.to_world(point.position);
            return marble_color(*material.noise, world).template to<T>();
        }
    }
    if constexpr ((kStage & kSurfacePictures) != 0 && compiled_in(ir::Effect::kTextures)) {
        if (material.texture != nullptr && point.has_uv) {
            ++counters.texture_lookups;
            return sample_texture(*material.texture, material.filter,
                                  texture_point(material, point))
                .template to<T>();
        }
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

template <SurfaceStage kStage, typename T>
SurfaceLook<T> look_at_surface(const ShadingScene<T>& scene, const PreparedMaterial<T>& material,
                               const SurfacePoint<T>& point, math::Vec3<T> direction,
                               Counters& counters) {
    SurfaceLook<T> look;
    look.kd = base_color<kStage>(scene, material, point, counters);
    look.leaving = math::dot(direction, point.geometric_normal) > T(0);

    math::Vec3<T> normal = point.shading_normal;
    if constexpr ((kStage & kSurfaceBent) != 0 && compiled_in(ir::Effect::kNormalMaps)) {
        if (material.bends() && point.has_uv) {
            ++counters.normal_map_lookups;
            normal = bent_normal(material, point);
            look.bent = !(normal == point.shading_normal);
        }
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

#define COBBLE_LOOK(kStage, T)                                                                     \
    template SurfaceLook<T> look_at_surface<kStage>(                                               \
        const ShadingScene<T>&, const PreparedMaterial<T>&, const SurfacePoint<T>&, math::Vec3<T>, \
        Counters&);
#define COBBLE_INSTANTIATE(T) \
    COBBLE_LOOK(0, T)         \
    COBBLE_LOOK(1, T)         \
    COBBLE_LOOK(2, T)         \
    COBBLE_LOOK(3, T)         \
    COBBLE_LOOK(4, T)         \
    COBBLE_LOOK(5, T)         \
    COBBLE_LOOK(6, T)         \
    COBBLE_LOOK(7, T)
COBBLE_INSTANTIATE(float)
COBBLE_INSTANTIATE(double)
#undef COBBLE_INSTANTIATE
#undef COBBLE_LOOK

}  // namespace cobble::renderer
