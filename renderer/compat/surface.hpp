// SPDX-License-Identifier: MIT
// The surface at a hit, and the light that lamps bring there.
#pragma once

#include "renderer/compat/trace.hpp"
#include "renderer/geometry/ray.hpp"

namespace cobble::renderer {

CompatSurface compat_surface(const CompatScene& scene, const Ray<double>& ray,
                             const Hit<double>& hit);

/// Ambient light, and what each lamp adds along a ray of direction `view`.
ir::Color compat_local_light(const CompatScene& scene, const CompatSurface& surface,
                             math::Vec3d view, Counters& counters);

/// The background along `direction`.
ir::Color compat_background(const ir::Scene& scene, math::Vec3d direction);

/// d - 2 (d . n) n.
constexpr math::Vec3d compat_reflect(math::Vec3d direction, math::Vec3d normal) {
    return direction - (2 * math::dot(direction, normal)) * normal;
}

}  // namespace cobble::renderer
