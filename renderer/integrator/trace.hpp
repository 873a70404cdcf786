// SPDX-License-Identifier: MIT
// Whitted's recursion without recursion: one ray at a time, from a stack of those still to follow.
//
// colour of a ray = what it meets + weight of the reflected ray times its colour + the same for the
// refracted one. All of it is linear, so each ray carries the product of weights on its way and
// adds to the sample; nothing has to be remembered for the way back.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/film/accumulator.hpp"
#include "renderer/integrator/shading_scene.hpp"
#include "renderer/integrator/surface_shading.hpp"
#include "renderer/intersect/intersect.hpp"
#include "renderer/intersect/surface.hpp"
#include "renderer/sampling/sampler.hpp"
#include "renderer/tile/stats.hpp"

namespace cobble::renderer {

enum class RayKind : std::uint8_t { kCamera, kReflected, kRefracted };

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

/// What one ray met.
template <typename T>
struct Shaded {
    Hit<T> hit;
    SurfacePoint<T> point;     ///< if hit
    SurfaceLook<T> look;       ///< if hit
    math::Vec3<T> color;       ///< of the surface under its lights, or of the background
    TracedRay<T> children[2];  ///< reflected before refracted
    std::uint32_t child_count = 0;
};

/// One light at one surface, for those who ask what made a pixel.
template <typename T>
struct LightAtSurface {
    std::uint32_t light = 0;
    bool visible = false;  ///< reaches the surface, on its lit side
    math::Vec3<T> contribution;
};

/// The first ray of a sample through (x, y) of the picture; draws lens and time if their effects
/// are on.
template <typename T>
TracedRay<T> camera_ray(const ShadingScene<T>& scene, const Sampler& sampler, double x, double y);

/// Meets the scene once: closest hit, colour, lights (a shadow ray each, if any can matter) and the
/// rays to follow, those whose weight is zero left out. `seen`, if given, hears of every light.
template <typename T>
Shaded<T> shade(const ShadingScene<T>& scene, const Sampler& sampler, const TracedRay<T>& ray,
                Counters& counters, std::vector<LightAtSurface<T>>* seen = nullptr);

/// A sample on its way, to be stepped until done.
template <typename T>
struct SampleTrace {
    std::vector<TracedRay<T>> stack;
    Sample sample;  ///< complete when done
    ir::ObjectId first_object;

    [[nodiscard]] bool done() const { return stack.empty(); }
};

/// Follows one ray of the stack.
template <typename T>
void step(const ShadingScene<T>& scene, const Sampler& sampler, SampleTrace<T>& trace,
          Counters& counters);

}  // namespace cobble::renderer
