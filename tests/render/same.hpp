// SPDX-License-Identifier: MIT
// Whether two renders are one, to the bit.
#pragma once

#include <cstring>

#include "tests/render/scene_builder.hpp"

namespace cobble::test {

/// All planes wanted, and a filter that moves samples.
inline renderer::Settings full(std::uint32_t width, std::uint32_t height, std::uint32_t samples) {
    renderer::Settings s = settings(width, height, samples);
    s.want_depth = s.want_normals = s.want_albedo = s.want_sample_count = true;
    s.filter = renderer::PixelFilter::kTent;
    return s;
}

inline bool same(const renderer::Plane32& a, const renderer::Plane32& b) {
    return a.width == b.width && a.height == b.height && a.values.size() == b.values.size() &&
           (a.values.empty() ||
            std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0);
}

inline bool same(const renderer::Picture& a, const renderer::Picture& b) {
    return same(a.color, b.color) && same(a.depth, b.depth) && same(a.normals, b.normals) &&
           same(a.albedo, b.albedo) && same(a.sample_count, b.sample_count);
}

/// Rays by kind. How many boxes and primitives they were tested against is the core's business.
inline bool same_rays(const renderer::Counters& a, const renderer::Counters& b) {
    return a.camera_rays == b.camera_rays && a.shadow_rays == b.shadow_rays &&
           a.reflected_rays == b.reflected_rays && a.refracted_rays == b.refracted_rays;
}

/// All but how many rays went in packets, which is the core's business too.
inline bool same(renderer::Counters a, renderer::Counters b) {
    a.packet_rays = b.packet_rays = 0;
    for (const auto counter : renderer::kCounters) {
        if (a.*counter != b.*counter) return false;
    }
    return true;
}

}  // namespace cobble::test
