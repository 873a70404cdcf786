// SPDX-License-Identifier: MIT
// Where two see-through bodies touch, face to face: blocks of glass in a wall, water in a tank.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/geometry/hit.hpp"
#include "renderer/geometry/ray.hpp"
#include "renderer/integrator/shading_scene.hpp"

namespace cobble::renderer {

/// `hit`, closest_hit()'s answer to `ray`, becomes what light meets: where the ray leaves one
/// see-through body and enters another at the same t there is no air in between. If their indices
/// differ the face that is entered is met, whichever object comes first; if they are equal there is
/// no surface at all, and what lies behind is met. Asks the scene further only for see-through
/// bodies that touch others.
template <typename T>
void cross_seams(const ShadingScene<T>& scene, Ray<T> ray, Hit<T>& hit);

/// Which objects those are, by the boxes around them: see ShadingScene::touching.
template <typename T>
std::vector<std::uint8_t> touching_bodies(const ShadingScene<T>& scene);

}  // namespace cobble::renderer
