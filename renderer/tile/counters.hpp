// SPDX-License-Identifier: MIT
// What a render did, counted exactly and the same on every machine.
#pragma once

#include <cstdint>

namespace cobble::renderer {

/// Rays and tests, summed over all threads.
struct Counters {
    std::uint64_t camera_rays = 0;
    std::uint64_t shadow_rays = 0;
    std::uint64_t reflected_rays = 0;
    std::uint64_t refracted_rays = 0;
    std::uint64_t box_tests = 0;
    std::uint64_t primitive_tests = 0;
    std::uint64_t packet_rays = 0;  ///< searched in packets, once for each question

    [[nodiscard]] std::uint64_t rays() const {
        return camera_rays + shadow_rays + reflected_rays + refracted_rays;
    }
    [[nodiscard]] std::uint64_t tests() const { return box_tests + primitive_tests; }
    Counters& operator+=(const Counters& other);
};

}  // namespace cobble::renderer
