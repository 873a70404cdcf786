// SPDX-License-Identifier: MIT
#include "renderer/integrator/trace.hpp"

#include "renderer/integrator/seams.hpp"
#include "renderer/sampling/mappings.hpp"

namespace cobble::renderer {
namespace {

template <typename T>
void shine(const ShadingScene<T>& scene, const Sampler& sampler, const TracedRay<T>& ray,
           Encounter<T>& met, Counters& counters, std::vector<LightAtSurface<T>>* seen) {
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        LightAtSurface<T> all{i, false, {}};
        for (std::uint32_t number = 0; number < scene.lights[i].samples; ++number) {
            const LightQuestion<T> light = ask_light(scene, sampler, ray, met, i, number, counters);
            bool visible = light.matters;
            if (visible && scene.effects.shadows()) {
                ++counters.shadow_rays;
                visible =
                    !any_hit(scene.geometry, light.shadow.ray, light.shadow.exclude, counters);
            }
            if (!visible) continue;
            met.light += light.contribution;
            all.visible = true;
            all.contribution += light.contribution;
        }
        if (seen != nullptr) seen->push_back(all);
    }
}

}  // namespace

template <typename T>
void begin_sample(const ShadingScene<T>& scene, PixelFilter filter, bool centred,
                  const Sampler& sampler, std::uint32_t x, std::uint32_t y, SampleTrace<T>& trace,
                  Counters& counters) {
    math::Vec2d at{x + 0.5, y + 0.5};
    if (!centred) {
        const math::Vec2d offset = sample_filter(sampler.draw(Draw::kPixel), filter);
        at.x += offset.x;
        at.y += offset.y;
    }
    trace.sample = {};
    trace.first_object = {};
    trace.stack.push_back(camera_ray(scene, sampler, at.x, at.y, counters));
}

template <typename T>
void bring_back(SampleTrace<T>& trace, const TracedRay<T>& ray, math::Vec3<T> color,
                const Offspring<T>& children) {
    trace.sample.color += (ray.weight * color).template to<double>();
    for (std::uint32_t i = children.count; i > 0; --i) {
        trace.stack.push_back(children.rays[i - 1]);
    }
}

BadSample bad_sample(const ir::Scene& scene, std::uint32_t x, std::uint32_t y, std::uint32_t sample,
                     ir::ObjectId first_object) {
    BadSample bad{x, y, sample, {}};
    if (first_object.valid()) bad.span = scene.objects[first_object.value].span;
    return bad;
}

template <typename T>
Shaded<T> shade(const ShadingScene<T>& scene, const Sampler& sampler, const TracedRay<T>& ray,
                Counters& counters, std::vector<LightAtSurface<T>>* seen) {
    Shaded<T> result;
    count(counters, ray.kind);
    result.met.hit = closest_hit(scene.geometry, ray.ray, ray.exclude, counters);
    cross_seams(scene, ray.ray, result.met.hit);
    meet(scene, ray.ray, result.met, counters);
    if (result.met.lit()) shine(scene, sampler, ray, result.met, counters, seen);
    result.color = color_of(scene, ray.ray, result.met, counters);
    scatter(scene, ray, result.met, result.children);
    return result;
}

template <typename T>
void step(const ShadingScene<T>& scene, const Sampler& sampler, SampleTrace<T>& trace,
          Counters& counters) {
    const TracedRay<T> ray = trace.stack.back();
    trace.stack.pop_back();
    const Shaded<T> shaded = shade(scene, sampler, ray, counters);
    if (ray.kind == RayKind::kCamera && shaded.met.hit) {
        see_first(trace.sample, shaded.met);
        trace.first_object = shaded.met.point.object;
    }
    bring_back(trace, ray, shaded.color, shaded.children);
}

#define COBBLE_INSTANTIATE(T)                                                             \
    template void begin_sample(const ShadingScene<T>&, PixelFilter, bool, const Sampler&, \
                               std::uint32_t, std::uint32_t, SampleTrace<T>&, Counters&); \
    template void bring_back(SampleTrace<T>&, const TracedRay<T>&, math::Vec3<T>,         \
                             const Offspring<T>&);                                        \
    template Shaded<T> shade(const ShadingScene<T>&, const Sampler&, const TracedRay<T>&, \
                             Counters&, std::vector<LightAtSurface<T>>*);                 \
    template void step(const ShadingScene<T>&, const Sampler&, SampleTrace<T>&, Counters&);
COBBLE_INSTANTIATE(float)
COBBLE_INSTANTIATE(double)
#undef COBBLE_INSTANTIATE

}  // namespace cobble::renderer
