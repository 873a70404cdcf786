// SPDX-License-Identifier: MIT
// Scenes small enough to work out by hand.
#pragma once

#include "ir/scene/scene.hpp"
#include "renderer/settings.hpp"

namespace cobble::test {

/// A camera at 0 0 5 that looks along -z with an opening of 90 degrees, one material, and a light
/// from the camera's side.
ir::Scene plain_scene(ir::Compat compat);

/// The plane z = `z`; `facing` 1 looks at the camera, -1 away from it.
void add_wall(ir::Scene& scene, double z, std::uint32_t material = 0, double facing = 1);

void add_plane(ir::Scene& scene, const ir::Plane& plane, std::uint32_t material);
void add_ball(ir::Scene& scene, math::Vec3d center, double radius, std::uint32_t material);

/// A mesh of two triangles, 2 by 2, at z = 0 around the z axis, u to the right and v upwards.
void add_picture_frame(ir::Scene& scene, std::uint32_t material = 0);

/// An image of one pixel.
ir::ImageId add_dot(ir::Scene& scene, std::uint8_t r, std::uint8_t g, std::uint8_t b);

/// Of the project's ray caster, or whatever the scene's program has.
renderer::Settings sized(std::uint32_t width, std::uint32_t height);

/// The middle pixel of three by three: the camera ray runs straight along -z.
ir::Color middle(const ir::Scene& scene, renderer::Settings settings);
double red(const ir::Scene& scene, const renderer::Settings& settings);

}  // namespace cobble::test
