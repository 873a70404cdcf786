// SPDX-License-Identifier: MIT
// How much can be seen of what float loses.
#pragma once

#include "ir/scene/scene.hpp"
#include "renderer/scene/prepared_scene.hpp"

namespace cobble::renderer {

/// Of faces that are flat in float and not as they are written: what they would cover together,
/// seen from the front, in square pixels that are `pixel` wide at distance 1 of the camera. Those
/// of the object and kind of `note`, which is one of `narrow`. Infinite for what is no triangle.
double flattened_pixels(const PreparedScene<float>& narrow, const ir::Scene& scene,
                        const PreparationNote& note, double pixel);

/// Of a whole object, its faces turned to the camera, or of a box around it if it is neither mesh
/// nor triangle. Infinite for a plane.
double object_pixels(const ir::Scene& scene, ir::ObjectId id, double pixel);

}  // namespace cobble::renderer
