// SPDX-License-Identifier: MIT
#include "renderer/integrator/trace.hpp"

#include "renderer/shading/cube_map.hpp"
#include "renderer/shading/fresnel.hpp"
#include "renderer/shading/phong.hpp"

namespace cobble::renderer {
namespace {

template <typename T>
bool is_zero(math::Vec3<T> v) {
    return v.x == T(0) && v.y == T(0) && v.z == T(0);
}

template <typename T>
math::Vec3<T> background(const ShadingScene<T>& scene, math::Vec3<T> direction) {
    if (scene.sky == nullptr) return scene.background;
    return sample_cube_map(*scene.source, *scene.sky, ir::TextureFilter::kBilinear,
                           direction.template to<double>())
        .template to<T>();
}

/// Whether anything lies between the surface and the light.
template <typename T>
bool hidden(const ShadingScene<T>& scene, const SurfacePoint<T>& point, const PreparedLight& light,
            const LightSample<T>& sample, T time, Counters& counters) {
    const Departure<T> departure = light.kind == ir::Light::Kind::kPoint
                                       ? leave_toward(point, sample.target, time)
                                       : leave(point, sample.direction, time);
    ++counters.shadow_rays;
    return any_hit(scene.geometry, departure.ray, departure.exclude, counters);
}

/// A light sends nothing from below: below the surface itself where shadows are simulated (the
/// surface hides it), and in any case below the surface that a map bends. Without shadows the
/// interpolated normal alone decides, as in the published programs.
template <typename T>
bool from_below(const ActiveEffects& effects, const SurfaceLook<T>& look, math::Vec3<T> to_light) {
    return (effects.shadows && !(math::dot(look.geometric, to_light) > T(0))) ||
           (look.bent && !(math::dot(look.smooth, to_light) > T(0)));
}

template <typename T>
math::Vec3<T> direct_light(const ShadingScene<T>& scene, const Sampler& sampler,
                           const TracedRay<T>& ray, const PreparedMaterial<T>& material,
                           const Shaded<T>& shaded, Counters& counters,
                           std::vector<LightAtSurface<T>>* seen) {
    const SurfaceLook<T>& look = shaded.look;
    const math::Vec3<T> reflected_view = reflect(ray.ray.direction, look.normal);
    math::Vec3<T> sum;
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const PreparedLight& light = scene.lights[i];
        const LightSample<T> sample = scene.effects.soft_shadows && light.has_size()
                                          ? light_sample(light, shaded.point.position,
                                                         sampler.draw(Draw::kLight, ray.path, i))
                                          : light_middle(light, shaded.point.position);
        math::Vec3<T> contribution =
            sample.intensity * phong(look.normal, sample.direction, reflected_view, look.kd,
                                     material.specular, material.shininess,
                                     scene.effects.highlights);
        if (from_below(scene.effects, look, sample.direction)) contribution = {};
        bool visible = !is_zero(contribution);
        if (visible && scene.effects.shadows) {
            visible = !hidden(scene, shaded.point, light, sample, ray.ray.time, counters);
        }
        if (visible) sum += contribution;
        if (seen != nullptr) {
            seen->push_back({i, visible, visible ? contribution : math::Vec3<T>{}});
        }
    }
    return sum;
}

template <typename T>
void follow(Shaded<T>& shaded, const TracedRay<T>& ray, RayKind kind, math::Vec3<T> direction,
            math::Vec3<T> weight, T index) {
    if (is_zero(weight)) return;
    const Departure<T> departure = leave(shaded.point, direction, ray.ray.time);
    TracedRay<T>& child = shaded.children[shaded.child_count++];
    child.ray = departure.ray;
    child.exclude = departure.exclude;
    child.weight = weight;
    child.index = index;
    child.path = kind == RayKind::kReflected ? ray.path.reflected() : ray.path.refracted();
    child.depth = ray.depth + 1;
    child.kind = kind;
}

/// Mirror and glass. There is no stack of media: leaving anything leads to index 1.
template <typename T>
void scatter(const ShadingScene<T>& scene, const TracedRay<T>& ray,
             const PreparedMaterial<T>& material, Shaded<T>& shaded) {
    if (ray.depth >= scene.bounces || is_zero(material.specular)) return;
    const bool see_through = material.refraction_index > T(0);
    if (!scene.effects.reflection && !(scene.effects.refraction && see_through)) return;
    const SurfaceLook<T>& look = shaded.look;
    const math::Vec3<T> tint = ray.weight * material.specular;
    T reflectance = 1;
    Refraction<T> through;
    if (see_through) {
        const T index = look.leaving ? T(1) : material.refraction_index;
        through = refract(ray.ray.direction, look.viewer_normal, ray.index, index);
        reflectance = through.reflectance;
    }
    if (scene.effects.reflection) {
        const math::Vec3<T> mirrored =
            keep_above(reflect(ray.ray.direction, look.viewer_normal), look.viewer_geometric);
        follow(shaded, ray, RayKind::kReflected, mirrored, tint * reflectance, ray.index);
    }
    if (scene.effects.refraction && see_through && !through.total) {
        const T index = look.leaving ? T(1) : material.refraction_index;
        follow(shaded, ray, RayKind::kRefracted,
               keep_above(through.direction, -look.viewer_geometric), tint * (T(1) - reflectance),
               index);
    }
}

/// 0.5 of the surroundings in the mirror's direction, 0.5 of the surface's own colour; unlit.
template <typename T>
math::Vec3<T> environment_mapped(const ShadingScene<T>& scene, const TracedRay<T>& ray,
                                 const PreparedMaterial<T>& material, const SurfaceLook<T>& look) {
    const math::Vec3<T> direction =
        keep_above(reflect(ray.ray.direction, look.viewer_normal), look.viewer_geometric);
    const auto around = sample_cube_map(*scene.source, *material.cube_map, material.filter,
                                        direction.template to<double>())
                            .template to<T>();
    return around * T(0.5) + look.kd * T(0.5);
}

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

}  // namespace

template <typename T>
TracedRay<T> camera_ray(const ShadingScene<T>& scene, const Sampler& sampler, double x, double y) {
    const CameraRay from_camera = scene.effects.depth_of_field
                                      ? scene.camera.through_lens(x, y, sampler.draw(Draw::kLens))
                                      : scene.camera.pinhole(x, y);
    TracedRay<T> result;
    result.ray.origin = scene.geometry.to_local(from_camera.origin);
    result.ray.direction = from_camera.direction.template to<T>();
    result.ray.time =
        static_cast<T>(scene.effects.motion_blur ? scene.camera.time(sampler.draw(Draw::kTime).x)
                                                 : scene.camera.time_open());
    return result;
}

template <typename T>
Shaded<T> shade(const ShadingScene<T>& scene, const Sampler& sampler, const TracedRay<T>& ray,
                Counters& counters, std::vector<LightAtSurface<T>>* seen) {
    Shaded<T> result;
    count(counters, ray.kind);
    result.hit = closest_hit(scene.geometry, ray.ray, ray.exclude, counters);
    if (!result.hit) {
        result.color = background(scene, ray.ray.direction);
        return result;
    }
    result.point = surface_at(scene.geometry, ray.ray, result.hit);
    const PreparedMaterial<T>& material = scene.material(result.point.material);
    result.look = look_at_surface(scene, material, result.point, ray.ray.direction);
    if (material.cube_map != nullptr) {
        result.color = environment_mapped(scene, ray, material, result.look);
    } else {
        result.color = scene.ambient * result.look.kd +
                       direct_light(scene, sampler, ray, material, result, counters, seen);
    }
    scatter(scene, ray, material, result);
    return result;
}

template <typename T>
void step(const ShadingScene<T>& scene, const Sampler& sampler, SampleTrace<T>& trace,
          Counters& counters) {
    const TracedRay<T> ray = trace.stack.back();
    trace.stack.pop_back();
    const Shaded<T> shaded = shade(scene, sampler, ray, counters);
    trace.sample.color += (ray.weight * shaded.color).template to<double>();
    if (ray.kind == RayKind::kCamera && shaded.hit) {
        trace.sample.hit = true;
        trace.sample.depth = static_cast<double>(shaded.hit.t);
        trace.sample.normal = shaded.look.normal.template to<double>();
        trace.sample.albedo = shaded.look.kd.template to<double>();
        trace.first_object = shaded.point.object;
    }
    for (std::uint32_t i = shaded.child_count; i > 0; --i) {
        trace.stack.push_back(shaded.children[i - 1]);
    }
}

template TracedRay<float> camera_ray(const ShadingScene<float>&, const Sampler&, double, double);
template Shaded<float> shade(const ShadingScene<float>&, const Sampler&, const TracedRay<float>&,
                             Counters&, std::vector<LightAtSurface<float>>*);
template void step(const ShadingScene<float>&, const Sampler&, SampleTrace<float>&, Counters&);
template TracedRay<double> camera_ray(const ShadingScene<double>&, const Sampler&, double, double);
template Shaded<double> shade(const ShadingScene<double>&, const Sampler&, const TracedRay<double>&,
                              Counters&, std::vector<LightAtSurface<double>>*);
template void step(const ShadingScene<double>&, const Sampler&, SampleTrace<double>&, Counters&);

}  // namespace cobble::renderer
