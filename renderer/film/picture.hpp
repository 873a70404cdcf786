// SPDX-License-Identifier: MIT
// The renderer's result: pixels as numbers, not yet quantised.
#pragma once

#include <cstdint>
#include <vector>

namespace cobble::renderer {

/// Rows from the top, `channels` numbers a pixel (3 colour, 1 depth and counts). Values are what
/// the film accumulated: display values, or light with `--transfer srgb`.
struct Plane32 {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 3;
    std::vector<float> values;

    [[nodiscard]] float at(std::uint32_t x, std::uint32_t y, std::uint32_t channel) const {
        return values[(std::size_t{y} * width + x) * channels + channel];
    }
};

/// A finished or partial render. Planes cover the crop if there is one, else the whole picture.
/// Optional planes are empty unless asked for. Pixels that were not reached (a cancelled render,
/// another shard's tiles) have sample count 0 and are black.
struct Picture {
    Plane32 color;
    Plane32 depth;    ///< distance along the ray in world units; infinity where nothing is hit
    Plane32 normals;  ///< shading normal, world space, -1..1; 0 0 0 where nothing is hit
    Plane32 albedo;   ///< surface colour before lighting
    Plane32 sample_count;
    bool complete = false;
};

}  // namespace cobble::renderer
