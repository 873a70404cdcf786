// SPDX-License-Identifier: MIT
// The lint `precision-loss`: what float, in which scenes are rendered unless asked otherwise,
// cannot resolve of this one.
//
// A renderer subtracts ir::local_origin(), a point near the camera, and narrows what is left to
// float, whose neighbours are `step` apart there. Three things can go wrong with an object, and
// each is measured after its transforms:
// - it reaches beyond what float can reckon with (math::kLargestCoordinate): it is never hit;
// - narrowing moves its corners, or its centre, by a quarter of its width or more: its shape is
//   lost. The width is the smallest height of a triangle, the shortest side of a box, a sphere's
//   diameter. What is written in numbers that float holds is not moved, however far away;
// - where it comes near the camera, within the picture, a pixel is less than one step wide.
#pragma once

#include <vector>

#include "frontend/source/diagnostic.hpp"
#include "ir/lower.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// Beyond it, 2^-24 (a float's precision) times the condition of a transform is 6 %: no digit is
/// left.
inline constexpr double kWorstCondition = 1e6;

/// Warnings for a scene with a camera, in the order of its objects: of many the first 20, and in
/// the last how many more. Of a mesh it looks at some of its faces, a million of all meshes
/// together, and speaks if half of them are lost, or any is left without an area; of a plane it
/// looks at what is seen nearest. The scene needs no images, uvs or normals.
std::vector<source::Diagnostic> precision_findings(const Scene& scene, PictureSize size);

}  // namespace cobble::ir
