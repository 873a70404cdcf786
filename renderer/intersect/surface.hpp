// SPDX-License-Identifier: MIT
// From a hit to the surface there, and from the surface to the next ray.
#pragma once

#include "renderer/geometry/hit.hpp"
#include "renderer/geometry/ray.hpp"
#include "renderer/scene/prepared_scene.hpp"

namespace cobble::renderer {

/// The surface at `hit`, an answer of closest_hit() to `ray`. The position is computed from the
/// primitive, not from t, in twice the precision and rounded once: it is as close to the surface as
/// numbers of type T are. Texture coordinates and tangents are filled only if they are wanted
/// and the scene was prepared with them.
template <typename T>
SurfacePoint<T> surface_at(const PreparedScene<T>& scene, const Ray<T>& ray, const Hit<T>& hit,
                           bool want_uv = true);

/// A ray from a surface: starts off it, on the side that `direction` points to, by the bound
/// stored with the point; never meets the same primitive again (see Exclude). t_min is 0.
template <typename T>
struct Departure {
    Ray<T> ray;
    Exclude exclude;
};

template <typename T>
Departure<T> leave(const SurfacePoint<T>& surface, math::Vec3<T> direction, T time);

/// The ray for "does this point see that one": leaves `surface` toward `target` (local
/// coordinates), which is at t = 1, and ends before it by what t may err there.
template <typename T>
Departure<T> leave_toward(const SurfacePoint<T>& surface, math::Vec3<T> target, T time);

}  // namespace cobble::renderer
