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
    return *this;
}

}  // namespace cobble::renderer
