// SPDX-License-Identifier: MIT
// How far the shapes of a scene reach.
#pragma once

#include <optional>
#include <vector>

#include "ir/math/box_bounds.hpp"
#include "ir/scene/scene.hpp"

namespace cobble::ir {

/// Of an object's shape in its own space; empty for a plane, or if nothing of it is finite.
math::BoxBounds<double> shape_bounds(const Scene& scene, const Object& object);

/// The same for many objects: a mesh that is placed often is looked through once. The scene must
/// outlive it and stay as it is.
class SceneBounds {
  public:
    explicit SceneBounds(const Scene& scene) : scene_(&scene), meshes_(scene.meshes.size()) {}

    /// shape_bounds().
    math::BoxBounds<double> shape(const Object& object);
    /// Of the object in the world, as it stands at its keys; under a matrix, of its shape's box.
    math::BoxBounds<double> world(const Object& object);
    /// Of all objects but planes.
    math::BoxBounds<double> all();

  private:
    const Scene* scene_;
    std::vector<std::optional<math::BoxBounds<double>>> meshes_;
};

/// SceneBounds::all().
math::BoxBounds<double> finite_bounds(const Scene& scene);

}  // namespace cobble::ir
