// SPDX-License-Identifier: MIT
#include "renderer/integrator/seams.hpp"

#include <cmath>
#include <limits>

#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"

namespace cobble::renderer {
namespace {

/// A face of a see-through body, as a ray meets it.
template <typename T>
struct Face {
    T index = 0;  ///< 0: not see-through
    bool leaving = false;
};

template <typename T>
Face<T> face_at(const ShadingScene<T>& scene, const Ray<T>& ray, const Hit<T>& hit) {
    const ir::MaterialId id = scene.source->objects[hit.object.value].material;
    const T index = scene.material(id).refraction_index;
    if (!(index > T(0))) return {};
    const SurfacePoint<T> point = surface_at(scene.geometry, ray, hit);
    return {index, math::dot(ray.direction, point.geometric_normal) > T(0)};
}

/// What else the ray meets at the very t of `hit`.
template <typename T>
Hit<T> tied_with(const ShadingScene<T>& scene, Ray<T> ray, const Hit<T>& hit) {
    constexpr T kInfinity = std::numeric_limits<T>::infinity();
    ray.t_min = std::nextafter(hit.t, -kInfinity);
    ray.t_max = std::nextafter(hit.t, kInfinity);
    Counters uncounted;
    return closest_hit(scene.geometry, ray, Exclude{hit.object, hit.face, false}, uncounted);
}

}  // namespace

template <typename T>
void cross_seams(const ShadingScene<T>& scene, Ray<T> ray, Hit<T>& hit) {
    if (!scene.seams) return;
    // Each turn ends farther on, behind one body more.
    while (hit) {
        const Face<T> here = face_at(scene, ray, hit);
        if (!(here.index > T(0))) return;
        const Hit<T> other = tied_with(scene, ray, hit);
        if (!other) return;
        const Face<T> there = face_at(scene, ray, other);
        if (!(there.index > T(0)) || there.leaving == here.leaving) return;
        const Hit<T> entered = here.leaving ? other : hit;
        if (here.index != there.index) {
            hit = entered;
            return;
        }
        ray.t_min = hit.t;
        Counters uncounted;
        hit = closest_hit(scene.geometry, ray, Exclude{entered.object, entered.face, true},
                          uncounted);
    }
}

template void cross_seams(const ShadingScene<float>&, Ray<float>, Hit<float>&);
template void cross_seams(const ShadingScene<double>&, Ray<double>, Hit<double>&);

}  // namespace cobble::renderer
