// SPDX-License-Identifier: MIT
// What becomes of one ray, in stages: what it meets, how that looks, what each light adds, which
// rays go on from there. What light does is said here once; who asks the scene for hits, one ray at
// a time or many, and in which order, is said elsewhere (trace.hpp, batched_tile.hpp).
//
//   meet, then for each light ask_light and a shadow ray, often as its `samples` say, then
//   color_of, then scatter
//
// Stages neither allocate, lock nor throw, and change nothing but what they are handed. Those that
// have several forms are compiled once for each.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/integrator/shading_scene.hpp"
#include "renderer/integrator/surface_shading.hpp"
#include "renderer/intersect/surface.hpp"
#include "renderer/sampling/sampler.hpp"
#include "renderer/tile/counters.hpp"

namespace cobble::renderer {

enum class RayKind : std::uint8_t { kCamera, kReflected, kRefracted };

void count(Counters& counters, RayKind kind);

/// A ray on its way through the tree.
template <typename T>
struct TracedRay {
    Ray<T> ray;                     ///< direction of unit length
    Exclude exclude;                ///< what it starts on
    math::Vec3<T> weight{1, 1, 1};  ///< of what it brings back, in its pixel
    T index = 1;                    ///< refraction index of where it travels
    PathAddress path;
    std::uint32_t depth = 0;  ///< turns since the camera
    RayKind kind = RayKind::kCamera;
};

/// The first ray of a sample through (x, y) of the picture, as the plan's RayStage has it: draws
/// lens and time, or neither.
template <RayStage kStage, typename T>
Ray<T> camera_ray_as(const ShadingScene<T>& scene, const Sampler& sampler, double x, double y);
template <typename T>
TracedRay<T> camera_ray(const ShadingScene<T>& scene, const Sampler& sampler, double x, double y,
                        Counters& counters);
/// Of `rays` such rays.
inline void count_draws(Counters& counters, RayStage stage, std::uint64_t rays) {
    if (stage == RayStage::kLens || stage == RayStage::kLensAndTime) counters.lens_draws += rays;
    if (stage == RayStage::kTime || stage == RayStage::kLensAndTime) counters.time_draws += rays;
}

/// What a ray met. All but `hit` means something only if there is one.
template <typename T>
struct Encounter {
    Hit<T> hit;
    SurfacePoint<T> point;
    SurfaceLook<T> look;
    const PreparedMaterial<T>* material = nullptr;
    math::Vec3<T> mirrored;  ///< for a highlight: the ray's direction, mirrored at look.normal
    math::Vec3<T> light;     ///< if lit: the sum of what the lights add, in their order

    /// Whether the lights have a say. Surfaces that show their surroundings are unlit.
    [[nodiscard]] bool lit() const { return hit && material->cube_map == nullptr; }
};

/// From `met.hit`, closest_hit()'s answer to `ray` behind seams that are none for light (see
/// seams.hpp), to all the rest but `mirrored`; no light has shone yet. The stage is the plan's, or
/// any that includes it.
template <SurfaceStage kStage, typename T>
void meet_as(const ShadingScene<T>& scene, const Ray<T>& ray, Encounter<T>& met,
             Counters& counters);
/// By the most general stage, and `mirrored` too.
template <typename T>
void meet(const ShadingScene<T>& scene, const Ray<T>& ray, Encounter<T>& met, Counters& counters);

/// What a light adds if nothing is in its way, and the ray that finds that out.
template <typename T>
struct LightQuestion {
    math::Vec3<T> contribution;
    bool matters = false;  ///< the contribution is not zero
    Departure<T> shadow;   ///< if it matters and shadows are simulated
};

/// For light `light` of the scene, at a surface that is lit; question `number` of its `samples`.
template <typename T>
LightQuestion<T> ask_light(const ShadingScene<T>& scene, const Sampler& sampler,
                           const TracedRay<T>& ray, const Encounter<T>& met, std::uint32_t light,
                           std::uint32_t number, Counters& counters);

/// What the ray brings back by itself: of the surface under its lights, or of the background.
template <typename T>
math::Vec3<T> color_of(const ShadingScene<T>& scene, const Ray<T>& ray, const Encounter<T>& met,
                       Counters& counters);

/// What a ray that meets nothing brings back.
template <typename T>
math::Vec3<T> sky_color(const ShadingScene<T>& scene, math::Vec3<T> direction, Counters& counters);
template <typename T>
math::Vec3<T> background(const ShadingScene<T>& scene, math::Vec3<T> direction,
                         Counters& counters) {
    return scene.sky == nullptr ? scene.background : sky_color(scene, direction, counters);
}

/// Rays that go on from a surface, reflected before refracted.
template <typename T>
struct Offspring {
    std::array<TracedRay<T>, 2> rays;
    std::uint32_t count = 0;
};

/// The rays to follow, those whose weight is zero left out; none from nothing.
template <typename T>
void scatter(const ShadingScene<T>& scene, const TracedRay<T>& ray, const Encounter<T>& met,
             Offspring<T>& children);

}  // namespace cobble::renderer
