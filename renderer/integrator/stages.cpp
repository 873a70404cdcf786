// SPDX-License-Identifier: MIT
#include "renderer/integrator/stages.hpp"

#include "renderer/shading/cube_map.hpp"
#include "renderer/shading/fresnel.hpp"
#include "renderer/shading/phong.hpp"

namespace cobble::renderer {
namespace {

template <typename T>
bool is_zero(math::Vec3<T> v) {
    return v.x == T(0) && v.y == T(0) && v.z == T(0);
}

/// A light sends nothing from below: below the surface itself where shadows are simulated (the
/// surface hides it), and in any case below the surface that a map bends. Without shadows the
/// interpolated normal alone decides, as in the published programs.
template <typename T>
bool from_below(const ActiveEffects& effects, const SurfaceLook<T>& look, math::Vec3<T> to_light) {
    return (effects.shadows() && !(math::dot(look.geometric, to_light) > T(0))) ||
           (look.bent && !(math::dot(look.smooth, to_light) > T(0)));
}

template <typename T>
void follow(Offspring<T>& children, const TracedRay<T>& ray, const SurfacePoint<T>& from,
            RayKind kind, math::Vec3<T> direction, math::Vec3<T> weight, T index) {
    if (is_zero(weight)) return;
    const Departure<T> departure = leave(from, direction, ray.ray.time);
    TracedRay<T>& child = children.rays[children.count++];
    child.ray = departure.ray;
    child.exclude = departure.exclude;
    child.weight = weight;
    child.index = index;
    child.path = kind == RayKind::kReflected ? ray.path.reflected() : ray.path.refracted();
    child.depth = ray.depth + 1;
    child.kind = kind;
}

/// 0.5 of the surroundings in the mirror's direction, 0.5 of the surface's own colour; unlit.
template <typename T>
math::Vec3<T> environment_mapped(const ShadingScene<T>& scene, const Ray<T>& ray,
                                 const PreparedMaterial<T>& material, const SurfaceLook<T>& look,
                                 Counters& counters) {
    ++counters.cube_map_lookups;
    const math::Vec3<T> direction =
        keep_above(reflect(ray.direction, look.viewer_normal), look.viewer_geometric);
    const auto around = sample_cube_map(*scene.source, *material.cube_map, material.filter,
                                        direction.template to<double>())
                            .template to<T>();
    return around * T(0.5) + look.kd * T(0.5);
}

}  // namespace

void count(Counters& counters, RayKind kind) {
    switch (kind) {
        case RayKind::kCamera:
            ++counters.camera_rays;
            break;
        case RayKind::kReflected:
            ++counters.reflected_rays;
            break;
        case RayKind::kRefracted:
            ++counters.refracted_rays;
            break;
    }
}

template <RayStage kStage, typename T>
Ray<T> camera_ray_as(const ShadingScene<T>& scene, const Sampler& sampler, double x, double y) {
    constexpr bool kLens = kStage == RayStage::kLens || kStage == RayStage::kLensAndTime;
    constexpr bool kTime = kStage == RayStage::kTime || kStage == RayStage::kLensAndTime;
    CameraRay from_camera;
    if constexpr (kLens) {
        from_camera = scene.camera.through_lens(x, y, sampler.draw(Draw::kLens));
    } else {
        from_camera = scene.camera.pinhole(x, y);
    }
    Ray<T> ray;
    ray.origin = scene.geometry.to_local(from_camera.origin);
    ray.direction = from_camera.direction.template to<T>();
    if constexpr (kTime) {
        ray.time = static_cast<T>(scene.camera.time(sampler.draw(Draw::kTime).x));
    } else {
        ray.time = static_cast<T>(scene.camera.time_open());
    }
    return ray;
}

template <typename T>
TracedRay<T> camera_ray(const ShadingScene<T>& scene, const Sampler& sampler, double x, double y,
                        Counters& counters) {
    count_draws(counters, scene.plan.rays, 1);
    TracedRay<T> result;
    switch (scene.plan.rays) {
        case RayStage::kPinhole:
            result.ray = camera_ray_as<RayStage::kPinhole>(scene, sampler, x, y);
            break;
        case RayStage::kLens:
            result.ray = camera_ray_as<RayStage::kLens>(scene, sampler, x, y);
            break;
        case RayStage::kTime:
            result.ray = camera_ray_as<RayStage::kTime>(scene, sampler, x, y);
            break;
        case RayStage::kLensAndTime:
            result.ray = camera_ray_as<RayStage::kLensAndTime>(scene, sampler, x, y);
            break;
    }
    return result;
}

template <SurfaceStage kStage, typename T>
void meet_as(const ShadingScene<T>& scene, const Ray<T>& ray, Encounter<T>& met,
             Counters& counters) {
    if (!met.hit) return;
    const ir::MaterialId material = scene.source->objects[met.hit.object.value].material;
    met.material = &scene.material(material);
    // Texture coordinates and tangents cost more than all the rest of a surface.
    constexpr bool kReadsUv = (kStage & (kSurfacePictures | kSurfaceBent)) != 0;
    const bool want_uv = kReadsUv && met.material->reads_uv();
    met.point = surface_at(scene.geometry, ray, met.hit, want_uv);
    met.look = look_at_surface<kStage>(scene, *met.material, met.point, ray.direction, counters);
    met.light = {};
}

template <typename T>
void meet(const ShadingScene<T>& scene, const Ray<T>& ray, Encounter<T>& met, Counters& counters) {
    meet_as<kAnySurface>(scene, ray, met, counters);
    if (met.lit() && scene.effects.highlights() &&
        has_highlight(met.material->specular, met.material->shininess)) {
        met.mirrored = reflect(ray.direction, met.look.normal);
    }
}

template <typename T>
LightQuestion<T> ask_light(const ShadingScene<T>& scene, const Sampler& sampler,
                           const TracedRay<T>& ray, const Encounter<T>& met, std::uint32_t light,
                           std::uint32_t number, Counters& counters) {
    const PreparedLight& source = scene.lights[light];
    const PreparedMaterial<T>& material = *met.material;
    const bool area = scene.effects.soft_shadows() && source.has_size();
    if (area) ++counters.light_draws;
    const LightSample<T> sample =
        area ? light_sample(source, met.point.position,
                            sampler.draw(Draw::kLight, ray.path, light, number, source.samples))
             : light_middle(source, met.point.position);
    const bool highlights =
        scene.effects.highlights() && has_highlight(material.specular, material.shininess);
    if (highlights) ++counters.highlights;
    LightQuestion<T> result;
    result.contribution =
        sample.intensity * phong(met.look.normal, sample.direction, met.mirrored, met.look.kd,
                                 material.specular, material.shininess, highlights);
    if (from_below(scene.effects, met.look, sample.direction)) result.contribution = {};
    result.matters = !is_zero(result.contribution);
    if (result.matters && scene.effects.shadows()) {
        result.shadow = source.kind == ir::Light::Kind::kPoint
                            ? leave_toward(met.point, sample.target, ray.ray.time)
                            : leave(met.point, sample.direction, ray.ray.time);
    }
    return result;
}

template <typename T>
math::Vec3<T> sky_color(const ShadingScene<T>& scene, math::Vec3<T> direction, Counters& counters) {
    ++counters.cube_map_lookups;
    return sample_cube_map(*scene.source, *scene.sky, ir::TextureFilter::kBilinear,
                           direction.template to<double>())
        .template to<T>();
}

template <typename T>
math::Vec3<T> color_of(const ShadingScene<T>& scene, const Ray<T>& ray, const Encounter<T>& met,
                       Counters& counters) {
    if (!met.hit) return background(scene, ray.direction, counters);
    if (!met.lit()) return environment_mapped(scene, ray, *met.material, met.look, counters);
    return scene.ambient * met.look.kd + met.light;
}

/// Mirror and glass. There is no stack of media: leaving anything leads to index 1.
template <typename T>
void scatter(const ShadingScene<T>& scene, const TracedRay<T>& ray, const Encounter<T>& met,
             Offspring<T>& children) {
    children.count = 0;
    if (!met.hit || ray.depth >= scene.bounces || !met.material->sends_on) return;
    const PreparedMaterial<T>& material = *met.material;
    const bool see_through = material.refraction_index > T(0);
    const SurfaceLook<T>& look = met.look;
    const math::Vec3<T> tint = ray.weight * material.specular;
    T reflectance = 1;
    Refraction<T> through;
    if (see_through) {
        const T index = look.leaving ? T(1) : material.refraction_index;
        through = refract(ray.ray.direction, look.viewer_normal, ray.index, index);
        reflectance = through.reflectance;
    }
    if (scene.effects.reflection()) {
        const math::Vec3<T> mirrored =
            keep_above(reflect(ray.ray.direction, look.viewer_normal), look.viewer_geometric);
        follow(children, ray, met.point, RayKind::kReflected, mirrored, tint * reflectance,
               ray.index);
    }
    if (scene.effects.refraction() && see_through && !through.total) {
        const T index = look.leaving ? T(1) : material.refraction_index;
        follow(children, ray, met.point, RayKind::kRefracted,
               keep_above(through.direction, -look.viewer_geometric), tint * (T(1) - reflectance),
               index);
    }
}

#define COBBLE_RAYS(kStage, T) \
    template Ray<T> camera_ray_as<kStage>(const ShadingScene<T>&, const Sampler&, double, double);
#define COBBLE_MEET(kStage, T) \
    template void meet_as<kStage>(const ShadingScene<T>&, const Ray<T>&, Encounter<T>&, Counters&);
#define COBBLE_INSTANTIATE(T)                                                                    \
    COBBLE_RAYS(RayStage::kPinhole, T)                                                           \
    COBBLE_RAYS(RayStage::kLens, T)                                                              \
    COBBLE_RAYS(RayStage::kTime, T)                                                              \
    COBBLE_RAYS(RayStage::kLensAndTime, T)                                                       \
    COBBLE_MEET(0, T)                                                                            \
    COBBLE_MEET(1, T)                                                                            \
    COBBLE_MEET(2, T)                                                                            \
    COBBLE_MEET(3, T)                                                                            \
    COBBLE_MEET(4, T)                                                                            \
    COBBLE_MEET(5, T)                                                                            \
    COBBLE_MEET(6, T)                                                                            \
    COBBLE_MEET(7, T)                                                                            \
    template void meet(const ShadingScene<T>&, const Ray<T>&, Encounter<T>&, Counters&);         \
    template TracedRay<T> camera_ray(const ShadingScene<T>&, const Sampler&, double, double,     \
                                     Counters&);                                                 \
    template math::Vec3<T> sky_color(const ShadingScene<T>&, math::Vec3<T>, Counters&);          \
    template LightQuestion<T> ask_light(const ShadingScene<T>&, const Sampler&,                  \
                                        const TracedRay<T>&, const Encounter<T>&, std::uint32_t, \
                                        std::uint32_t, Counters&);                               \
    template math::Vec3<T> color_of(const ShadingScene<T>&, const Ray<T>&, const Encounter<T>&,  \
                                    Counters&);                                                  \
    template void scatter(const ShadingScene<T>&, const TracedRay<T>&, const Encounter<T>&,      \
                          Offspring<T>&);
COBBLE_INSTANTIATE(float)
COBBLE_INSTANTIATE(double)
#undef COBBLE_INSTANTIATE
#undef COBBLE_MEET
#undef COBBLE_RAYS

}  // namespace cobble::renderer
