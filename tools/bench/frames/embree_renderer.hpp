// SPDX-License-Identifier: MIT
// The least of a renderer over Embree: packets of 16 camera rays, then packets of their shadow
// rays; Lambert's shading with one point light, as Cobble shades matt surfaces. What a renderer may
// at most hope to reach with these kernels.
#pragma once

#include "renderer/film/picture.hpp"
#include "tools/bench/frames/scene_files.hpp"

namespace cobble::bench {

struct EmbreeFrame {
    renderer::Plane32 color;
    double make_seconds = 0;     ///< filling Embree's buffers
    double prepare_seconds = 0;  ///< building
    double render_seconds = 0;
    double render_cpu = 0;  ///< of all threads
    double camera_rays = 0;
};

/// No glass. Threads take tiles of 32 x 32 pixels. Robust flag on, as Cobble is watertight.
EmbreeFrame render_with_embree(const Input& input, const ScenePlan& plan, unsigned threads);

}  // namespace cobble::bench
