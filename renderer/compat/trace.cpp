// SPDX-License-Identifier: MIT
#include "renderer/compat/trace.hpp"

#include <cmath>

#include "renderer/compat/surface.hpp"
#include "renderer/intersect/intersect.hpp"

namespace cobble::renderer {
namespace {

/// What happens to a ray at the face of a transparent thing.
struct Crossing {
    bool total = false;  ///< nothing goes through
    math::Vec3d direction;
    double index = 1;  ///< on the other side
    double reflectance = 1;
};

/// Snell's law and Schlick's approximation. A ray that comes from behind leaves the thing into air;
/// things inside things are not kept account of.
Crossing cross_face(math::Vec3d direction, math::Vec3d outward, double index, double material) {
    const bool leaves = math::dot(direction, outward) > 0;
    const math::Vec3d normal = leaves ? -outward : outward;
    Crossing crossing;
    crossing.index = leaves ? 1 : material;
    const double cosine = math::dot(direction, normal);
    const double eta = index / crossing.index;
    const double radicand = 1 - eta * eta * (1 - cosine * cosine);
    if (!(radicand >= 0)) {
        crossing.total = true;
        return crossing;
    }
    crossing.direction =
        math::normalize(eta * (direction - cosine * normal) - std::sqrt(radicand) * normal);
    const double ratio = (crossing.index - index) / (crossing.index + index);
    const double head_on = ratio * ratio;
    const double c = index <= crossing.index ? std::fabs(cosine)
                                             : std::fabs(math::dot(crossing.direction, normal));
    const double rest = 1 - c;
    crossing.reflectance = head_on + (1 - head_on) * (rest * rest * rest * rest * rest);
    return crossing;
}

Ray<double> ray_of(math::Vec3d origin, math::Vec3d direction, double t_min) {
    Ray<double> ray;
    ray.origin = origin;
    ray.direction = direction;
    ray.t_min = t_min;
    return ray;
}

}  // namespace

void CompatTrace::start(const CompatScene& scene, math::Vec3d origin, math::Vec3d direction) {
    color_ = {};
    first_object_ = {};
    waiting_.clear();
    waiting_.push_back({scene.prepared->to_local(origin), direction, {}, 0, 1, 0, {1, 1, 1}});
}

void CompatTrace::step(const CompatScene& scene, Counters& counters) {
    const Waiting waiting = waiting_.back();
    waiting_.pop_back();
    const Ray<double> ray = ray_of(waiting.origin, waiting.direction, waiting.t_min);
    const Hit<double> hit = closest_hit(*scene.prepared, ray, waiting.exclude, counters);
    if (waiting.depth == 0) first_object_ = hit.object;
    if (!hit) {
        color_ += waiting.factor * compat_background(*scene.scene, waiting.direction);
        return;
    }
    const CompatSurface surface = compat_surface(scene, ray, hit);
    color_ += waiting.factor * compat_local_light(scene, surface, waiting.direction, counters);
    if (waiting.depth < scene.rules.bounces) send_on(scene, waiting, surface, counters);
}

void CompatTrace::send_on(const CompatScene& scene, const Waiting& ray,
                          const CompatSurface& surface, Counters& counters) {
    // Both the mirrored and the transmitted colour are tinted by the specular one.
    const ir::Color factor = ray.factor * surface.material->specular;
    if (factor == ir::Color{}) return;
    Waiting next{surface.point, {},    surface.self, CompatRules::kStart, ray.index,
                 ray.depth + 1, factor};

    double reflectance = 1;
    const double material = surface.material->refraction_index;
    if (scene.rules.refraction && material > 0) {
        const Crossing crossing = cross_face(ray.direction, surface.normal, ray.index, material);
        if (!crossing.total) {
            reflectance = crossing.reflectance;
            next.direction = crossing.direction;
            next.index = crossing.index;
            next.factor = (1 - reflectance) * factor;
            waiting_.push_back(next);
            ++counters.refracted_rays;
        }
    }
    next.direction = compat_reflect(ray.direction, surface.normal);
    next.index = ray.index;
    next.factor = reflectance * factor;
    waiting_.push_back(next);
    ++counters.reflected_rays;
}

CompatFirstHit compat_first_hit(const CompatScene& scene, math::Vec3d origin, math::Vec3d direction,
                                Counters& counters) {
    const Ray<double> ray = ray_of(scene.prepared->to_local(origin), direction, 0);
    const Hit<double> hit = closest_hit(*scene.prepared, ray, Exclude{}, counters);
    if (!hit) return {};
    const CompatSurface surface = compat_surface(scene, ray, hit);
    return {true, hit.t, surface.normal, surface.kd};
}

}  // namespace cobble::renderer
