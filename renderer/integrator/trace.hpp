// SPDX-License-Identifier: MIT
// Whitted's recursion without recursion: a stack of the rays still to follow.
//
// colour of a ray = what it meets + weight of the reflected ray times its colour + the same for the
// refracted one. All of it is linear, so each ray carries the product of weights on its way and
// adds to the sample; nothing has to be remembered for the way back.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/film/accumulator.hpp"
#include "renderer/integrator/shading_scene.hpp"
#include "renderer/integrator/stages.hpp"
#include "renderer/intersect/intersect.hpp"
#include "renderer/sampling/sampler.hpp"
#include "renderer/settings.hpp"
#include "renderer/tile/stats.hpp"

namespace cobble::renderer {

/// A sample on its way.
template <typename T>
struct SampleTrace {
    std::vector<TracedRay<T>> stack;
    Sample sample;  ///< complete when done
    ir::ObjectId first_object;

    [[nodiscard]] bool done() const { return stack.empty(); }
};

/// What a stack has to hold at most: each ray taken off puts at most two on, one turn deeper.
template <typename T>
std::size_t deepest_stack(const ShadingScene<T>& scene) {
    return scene.bounces + std::size_t{2};
}

/// Puts the first ray of a sample of pixel (x, y) on the trace's stack, which is empty: through the
/// pixel's centre if `centred`, else where the filter says.
template <typename T>
void begin_sample(const ShadingScene<T>& scene, PixelFilter filter, bool centred,
                  const Sampler& sampler, std::uint32_t x, std::uint32_t y, SampleTrace<T>& trace,
                  Counters& counters);

/// What the pictures beside the colour see of a sample: the hit of its first ray, if there is one.
template <typename T>
void see_first(Sample& sample, const Encounter<T>& met) {
    if (!met.hit) return;
    sample.hit = true;
    sample.depth = static_cast<double>(met.hit.t);
    sample.normal = met.look.normal.template to<double>();
    sample.albedo = met.look.kd.template to<double>();
}

/// Adds to the sample what `ray`, taken off its stack, brought back, and puts the rays that go on
/// from there on the stack. Samples have one sequence of bits only if their rays are taken from the
/// top of the stack, one after the other.
template <typename T>
void bring_back(SampleTrace<T>& trace, const TracedRay<T>& ray, math::Vec3<T> color,
                const Offspring<T>& children);

/// For a sample that came out as no number.
BadSample bad_sample(const ir::Scene& scene, std::uint32_t x, std::uint32_t y, std::uint32_t sample,
                     ir::ObjectId first_object);

/// All that one ray did.
template <typename T>
struct Shaded {
    Encounter<T> met;
    math::Vec3<T> color;
    Offspring<T> children;
};

/// One light at one surface, for those who ask what made a pixel.
template <typename T>
struct LightAtSurface {
    std::uint32_t light = 0;
    bool visible = false;  ///< reaches the surface, on its lit side
    math::Vec3<T> contribution;
};

/// All stages for one ray: the reference. `seen`, if given, hears of every light.
template <typename T>
Shaded<T> shade(const ShadingScene<T>& scene, const Sampler& sampler, const TracedRay<T>& ray,
                Counters& counters, std::vector<LightAtSurface<T>>* seen = nullptr);

/// Follows one ray of the stack.
template <typename T>
void step(const ShadingScene<T>& scene, const Sampler& sampler, SampleTrace<T>& trace,
          Counters& counters);

}  // namespace cobble::renderer
