// SPDX-License-Identifier: MIT
#include "renderer/compat/surface.hpp"

#include <cmath>

#include "ir/math/elementary.hpp"
#include "renderer/compat/texture.hpp"
#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"
#include "renderer/shading/noise.hpp"

namespace cobble::renderer {
namespace {

using Highlight = CompatRules::Highlight;

bool nearest(const CompatScene& scene, const ir::Material& material) {
    return scene.rules.nearest_texel || material.texture_filter == ir::TextureFilter::kNearest;
}

/// The project's reading of a normal map: red and green count downwards, and the third axis is the
/// flat triangle's, not the interpolated normal.
math::Vec3d mapped_normal_of(const SurfacePoint<double>& at, ir::Color c) {
    const math::Vec3d tangent = math::normalize(at.dp_du);
    const math::Vec3d bitangent = math::normalize(at.dp_dv);
    const math::Vec3d axis = math::normalize(math::cross(tangent, bitangent));
    return math::normalize(((1 - 2 * c.x) * tangent + (1 - 2 * c.y) * bitangent) +
                           (2 * c.z - 1) * axis);
}

/// The way to a lamp, how far it is, and its colour there.
struct Lamp {
    math::Vec3d direction;
    double distance = std::numeric_limits<double>::infinity();
    ir::Color color;
};

Lamp lamp_at(const CompatScene& scene, const ir::Light& light, math::Vec3d point) {
    if (light.kind == ir::Light::Kind::kDirectional) {
        return {-light.direction, std::numeric_limits<double>::infinity(), light.color};
    }
    const math::Vec3d way = scene.prepared->to_local(light.position) - point;
    const double distance = math::length(way);
    Lamp lamp{math::normalize(way), distance, light.color};
    const double square = distance * distance;
    if (scene.rules.falloff == CompatRules::Falloff::kOnePlus) {
        lamp.color = light.color / (1 + light.falloff * square);
    } else if (scene.rules.falloff == CompatRules::Falloff::kProportional && light.falloff > 0) {
        lamp.color = light.color / (light.falloff * square);
    }
    return lamp;
}

double highlight(const CompatScene& scene, const CompatSurface& surface, math::Vec3d view,
                 math::Vec3d to_light) {
    double along = 0;
    if (scene.rules.highlight == Highlight::kReflectedView) {
        along = math::dot(compat_reflect(view, surface.normal), to_light);
    } else {
        const double lambert = math::dot(surface.normal, to_light);
        const double clamped = lambert > 0 ? lambert : 0;
        along = -math::dot((2 * clamped) * surface.normal - to_light, view);
    }
    const double base = along > 0 ? (along < 1 ? along : 1) : 0;
    // pow(0, 0) is 1: without shininess the whole surface is highlight, as it was.
    return math::pow(base, surface.material->shininess);
}

bool in_shadow(const CompatScene& scene, const CompatSurface& surface, const Lamp& lamp,
               Counters& counters) {
    if (!scene.rules.shadows) return false;
    ++counters.shadow_rays;
    Ray<double> ray;
    ray.origin = surface.point;
    ray.direction = lamp.direction;
    ray.t_min = CompatRules::kStart;
    ray.t_max = lamp.distance;
    return any_hit(*scene.prepared, ray, surface.self, counters);
}

/// Half of a material's cube map and half of its noise. Where there is no noise the project reads
/// memory that nobody wrote; here that half is black.
ir::Color mirrored(const CompatScene& scene, const CompatSurface& surface, math::Vec3d view) {
    const ir::Material& material = *surface.material;
    const ir::CubeMap& map = scene.scene->cube_maps[material.cube_map.value];
    ir::Color color =
        0.5 * compat_cube_map(*scene.scene, map, compat_reflect(view, surface.normal));
    if (material.has_noise) color += 0.5 * surface.kd;
    return color;
}

}  // namespace

CompatSurface compat_surface(const CompatScene& scene, const Ray<double>& ray,
                             const Hit<double>& hit) {
    const SurfacePoint<double> at = surface_at(*scene.prepared, ray, hit);
    const ir::Material& material = scene.scene->materials[at.material.value];
    CompatSurface surface;
    surface.point = ray.origin + hit.t * ray.direction;
    surface.normal = at.shading_normal;
    surface.material = &material;
    surface.kd = material.diffuse;
    const bool curved = at.kind == ir::ShapeKind::kSphere || at.kind == ir::ShapeKind::kBox;
    if (!curved) surface.self = {hit.object, hit.face, false};

    // Only meshes have texture coordinates in the published programs.
    const bool has_uv = at.has_uv && at.kind == ir::ShapeKind::kMesh;
    const math::Vec2d uv{at.uv.x * material.texture_scale.x, at.uv.y * material.texture_scale.y};
    const bool whole = nearest(scene, material);
    if (scene.rules.noise && material.has_noise) {
        surface.kd = marble_color(material.noise, scene.prepared->to_world(surface.point));
    } else if (scene.rules.textures && material.texture.valid() && has_uv) {
        surface.kd = compat_texture(scene.scene->images[material.texture.value], uv, whole);
    }
    if (scene.rules.normal_maps && material.normal_map.valid() && has_uv && at.has_tangents) {
        const ir::Image& map = scene.scene->images[material.normal_map.value];
        if (!map.missing) surface.normal = mapped_normal_of(at, compat_texture(map, uv, whole));
    }
    return surface;
}

ir::Color compat_local_light(const CompatScene& scene, const CompatSurface& surface,
                             math::Vec3d view, Counters& counters) {
    const ir::Material& material = *surface.material;
    ir::Color color = scene.scene->background.ambient *
                      (scene.rules.ambient_shows_texture ? surface.kd : material.diffuse);
    const bool mirror = scene.rules.mirror_materials && material.cube_map.valid();
    const bool shines =
        scene.rules.highlight != Highlight::kNone && material.specular != ir::Color{};
    for (const ir::Light& light : scene.scene->lights) {
        if (mirror) {
            color += mirrored(scene, surface, view);
            continue;
        }
        const Lamp lamp = lamp_at(scene, light, surface.point);
        const double lambert = math::dot(surface.normal, lamp.direction);
        // Half of all lamps are behind their surface, and need no shadow ray.
        if (!(lambert > 0) && !shines) continue;
        if (in_shadow(scene, surface, lamp, counters)) continue;
        if (lambert > 0) color += (lambert * lamp.color) * surface.kd;
        if (shines) {
            const double amount = highlight(scene, surface, view, lamp.direction);
            color += (amount * lamp.color) * material.specular;
        }
    }
    return color;
}

ir::Color compat_background(const ir::Scene& scene, math::Vec3d direction) {
    const ir::CubeMapId map = scene.background.cube_map;
    if (!map.valid()) return scene.background.color;
    return compat_cube_map(scene, scene.cube_maps[map.value], direction);
}

}  // namespace cobble::renderer
