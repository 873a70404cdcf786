// SPDX-License-Identifier: MIT
// Tests of boxes, spheres and planes, and ways to leave a surface, that are known to be wrong: kept
// so that the tests of hard cases can be seen to find them. Triangles: see wrong_kernels.hpp.
#pragma once

#include <optional>

#include "renderer/geometry/box.hpp"
#include "renderer/geometry/sphere.hpp"
#include "renderer/intersect/surface.hpp"
#include "tests/hard/wrong_kernels.hpp"

namespace cobble::test {

using FloatRay = renderer::Ray<float>;

/// Slabs as they are often written (Kay and Kajiya 1986; the min and max of either end): a ray that
/// runs in a face's plane multiplies 0 by infinity.
std::optional<renderer::BoxHit<float>> nan_slabs(const FloatRay& ray,
                                                 const renderer::BoxBounds<float>& box);
/// With reciprocals of 12 bits, as the instruction for approximate ones gives.
std::optional<renderer::BoxHit<float>> rough_reciprocal(const FloatRay& ray,
                                                        const renderer::BoxBounds<float>& box);
std::optional<renderer::BoxHit<float>> sound_box(const FloatRay& ray,
                                                 const renderer::BoxBounds<float>& box);

/// The quadratic formula as it is in school books, in float. Roots of a x^2 + b x + c.
std::optional<renderer::Roots<float>> plain_quadratic(float a, float b, float c);
std::optional<renderer::Roots<float>> plain_sphere(const FloatRay& ray, math::Vec3<float> center,
                                                   float radius);
std::optional<renderer::Roots<float>> sound_sphere(const FloatRay& ray, math::Vec3<float> center,
                                                   float radius);

/// A plane in float that a ray within 1e-6 of parallel is said to miss.
std::optional<float> parallel_epsilon(const FloatRay& ray, const renderer::PlaneKey& plane);
std::optional<float> sound_plane(const FloatRay& ray, const renderer::PlaneKey& plane);

/// A search through everything that rests in the world and is not placed, by these kernels. With
/// sound ones it is brute force but for the boxes of spheres.
struct Kernels {
    bool (*triangle)(const renderer::RayShear<float>&, const Triangle&) = sound;
    std::optional<renderer::BoxHit<float>> (*box)(const FloatRay&,
                                                  const renderer::BoxBounds<float>&) = sound_box;
    std::optional<renderer::Roots<float>> (*sphere)(const FloatRay&, math::Vec3<float>,
                                                    float) = sound_sphere;
    std::optional<float> (*plane)(const FloatRay&, const renderer::PlaneKey&) = sound_plane;
    /// Nearest by a triangle's own t: that of Möller and Trumbore, in float.
    bool own_t = false;

    renderer::Hit<float> operator()(const renderer::PreparedScene<float>& scene,
                                    const FloatRay& ray) const;
};

/// t of the plane of a triangle as Möller and Trumbore have it, in float.
float moller_trumbore_t(const FloatRay& ray, const Triangle& v);

/// Leaves by an absolute distance along the direction, whatever the scene's size, and leaves
/// nothing out.
template <typename T>
renderer::Departure<T> leave_by_epsilon(const renderer::SurfacePoint<T>& surface,
                                        math::Vec3<T> direction, T time) {
    const T epsilon = static_cast<T>(1e-4);
    renderer::Departure<T> d;
    d.ray.origin = surface.position + direction * (epsilon / length(direction));
    d.ray.direction = direction;
    d.ray.time = time;
    return d;
}

/// Toward `target`, with the same distance at both ends.
template <typename T>
renderer::Departure<T> leave_toward_by_epsilon(const renderer::SurfacePoint<T>& surface,
                                               math::Vec3<T> target, T time) {
    auto d = leave_by_epsilon(surface, normalize(target - surface.position), time);
    d.ray.t_max = length(target - surface.position) - static_cast<T>(1e-4);
    return d;
}

}  // namespace cobble::test
