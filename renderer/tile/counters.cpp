// SPDX-License-Identifier: MIT
#include "renderer/tile/counters.hpp"

namespace cobble::renderer {

Counters& Counters::operator+=(const Counters& other) {
    camera_rays += other.camera_rays;
    shadow_rays += other.shadow_rays;
    reflected_rays += other.reflected_rays;
    refracted_rays += other.refracted_rays;
    box_tests += other.box_tests;
    primitive_tests += other.primitive_tests;
    packet_rays += other.packet_rays;
    lens_draws += other.lens_draws;
    time_draws += other.time_draws;
    light_draws += other.light_draws;
    highlights += other.highlights;
    texture_lookups += other.texture_lookups;
    normal_map_lookups += other.normal_map_lookups;
    noise_evaluations += other.noise_evaluations;
    cube_map_lookups += other.cube_map_lookups;
    return *this;
}

}  // namespace cobble::renderer
