// SPDX-License-Identifier: MIT
// The published programs' pictures of depth and normals, from the planes that a render keeps.
#pragma once

#include "ir/scene/scene.hpp"
#include "renderer/film/picture.hpp"

namespace cobble::renderer {

/// Picture::depth as grey in [0, 1], one channel: (max - t) / (max - min), clamped, so that white
/// is near; misses are black. In the edition of 2016 (t - min) / (max - min): white is far, misses
/// included. max = min gives a step there. Write it with Quantise::kTruncate.
Plane32 compat_depth_picture(const Plane32& depth, ir::Compat compat, double min, double max);

/// Picture::normals as colours: the magnitude of each component; in the edition of 2016
/// (n + 1) / 2. Misses are black, and in 2016 mid grey.
Plane32 compat_normals_picture(const Plane32& normals, ir::Compat compat);

}  // namespace cobble::renderer
