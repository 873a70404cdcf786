// SPDX-License-Identifier: MIT
// What a render did, counted exactly and the same on every machine.
#pragma once

#include <cstdint>
#include <iterator>

namespace cobble::renderer {

/// Rays, tests, and what shading did, summed over all threads.
struct Counters {
    std::uint64_t camera_rays = 0;
    std::uint64_t shadow_rays = 0;
    std::uint64_t reflected_rays = 0;
    std::uint64_t refracted_rays = 0;
    std::uint64_t box_tests = 0;
    std::uint64_t primitive_tests = 0;
    std::uint64_t packet_rays = 0;  ///< searched in packets, once for each question

    // What effects do beside rays: nothing, if they are off.
    std::uint64_t lens_draws = 0;   ///< places on the lens
    std::uint64_t time_draws = 0;   ///< moments of the shutter
    std::uint64_t light_draws = 0;  ///< places on lights with a size
    std::uint64_t highlights = 0;   ///< asked of a light at a surface that may have one
    std::uint64_t texture_lookups = 0;
    std::uint64_t normal_map_lookups = 0;  ///< surfaces with a normal map, a bump map or both
    std::uint64_t noise_evaluations = 0;
    std::uint64_t cube_map_lookups = 0;

    [[nodiscard]] std::uint64_t rays() const {
        return camera_rays + shadow_rays + reflected_rays + refracted_rays;
    }
    [[nodiscard]] std::uint64_t tests() const { return box_tests + primitive_tests; }
    Counters& operator+=(const Counters& other);
};

/// All of them, in their order.
inline constexpr std::uint64_t Counters::*kCounters[] = {
    &Counters::camera_rays,        &Counters::shadow_rays,       &Counters::reflected_rays,
    &Counters::refracted_rays,     &Counters::box_tests,         &Counters::primitive_tests,
    &Counters::packet_rays,        &Counters::lens_draws,        &Counters::time_draws,
    &Counters::light_draws,        &Counters::highlights,        &Counters::texture_lookups,
    &Counters::normal_map_lookups, &Counters::noise_evaluations, &Counters::cube_map_lookups};
static_assert(sizeof(Counters) == std::size(kCounters) * sizeof(std::uint64_t),
              "a counter is missing in the list");

}  // namespace cobble::renderer
