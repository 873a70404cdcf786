// SPDX-License-Identifier: MIT
#include "renderer/camera/camera.hpp"

#include "ir/math/elementary.hpp"
#include "renderer/sampling/mappings.hpp"

namespace cobble::renderer {

PreparedCamera::PreparedCamera(const ir::Camera& camera, std::uint32_t width, std::uint32_t height)
    : center_(camera.center),
      forward_(camera.forward),
      right_(camera.right),
      up_(camera.up),
      aperture_(camera.aperture),
      focus_distance_(camera.focus_distance),
      blades_(camera.blades),
      shutter_open_(camera.shutter_open),
      shutter_close_(camera.shutter_close),
      width_(width),
      height_(height),
      half_pixel_(math::tan(camera.angle / 2) / height) {}

CameraRay PreparedCamera::through_lens(double x, double y, Uniform2 lens) const {
    if (!(focus_distance_ > 0)) return pinhole(x, y);
    const math::Vec2d place = blades_ >= 3 ? sample_polygon(lens, blades_) : sample_disk(lens);
    const double radius = aperture_ / 2;
    const math::Vec3d offset = right_ * (radius * place.x) + up_ * (radius * place.y);
    return {center_ + offset, math::normalize(toward(x, y) - offset / focus_distance_)};
}

}  // namespace cobble::renderer
