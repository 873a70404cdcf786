// SPDX-License-Identifier: MIT
// What a surface looks like at a hit, before light falls on it: its colour and its normals.
#pragma once

#include "renderer/geometry/hit.hpp"
#include "renderer/integrator/shading_scene.hpp"
#include "renderer/tile/counters.hpp"

namespace cobble::renderer {

/// Unit vectors. "Flipped" means turned toward the viewer on the back of triangles, meshes and
/// planes; spheres and boxes keep their outward normals, so that their inside is unlit.
template <typename T>
struct SurfaceLook {
    math::Vec3<T> kd;                ///< noise, else texture, else diffuse
    math::Vec3<T> normal;            ///< for light: interpolated, bent by maps, flipped
    math::Vec3<T> smooth;            ///< the same before maps bent it
    math::Vec3<T> geometric;         ///< flipped
    math::Vec3<T> viewer_geometric;  ///< the geometric normal on the viewer's side, of any shape
    math::Vec3<T> viewer_normal;     ///< `normal` on the viewer's side, for secondary rays
    bool leaving = false;            ///< the ray comes from inside: d . N > 0
    bool bent = false;               ///< a map bent the normal
};

/// `direction` is the ray's, unit. `kStage`: what the look of any surface may depend on.
template <SurfaceStage kStage, typename T>
SurfaceLook<T> look_at_surface(const ShadingScene<T>& scene, const PreparedMaterial<T>& material,
                               const SurfacePoint<T>& point, math::Vec3<T> direction,
                               Counters& counters);

}  // namespace cobble::renderer
