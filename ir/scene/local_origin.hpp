// SPDX-License-Identifier: MIT
// The point that coordinates are made relative to before they are narrowed to float.
#pragma once

#include "ir/scene/bounds.hpp"

namespace cobble::ir {

/// A point of a grid whose lines are a power of two apart, so that moving everything by whole steps
/// changes no bit. As a rule it is math::grid_origin() of all objects but planes, seen from the
/// camera: a thing around zero keeps its coordinates. Where that grid's step, as coarse as the
/// scene is wide, is more than 64 times the reach of what lies nearest to the camera (its farthest
/// coordinate from there; a plane's distance), it is the point nearest to the camera of a grid of
/// some 64 such reaches: then one far thing does not cost the near ones their digits, and these
/// keep 18 of the 24 that float has.
math::Vec3d local_origin(const Scene& scene, SceneBounds& bounds);

}  // namespace cobble::ir
