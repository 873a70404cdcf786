// SPDX-License-Identifier: MIT
#include "renderer/camera/camera.hpp"

#include "ir/math/elementary.hpp"
#include "renderer/sampling/mappings.hpp"

namespace cobble::renderer {

PreparedCamera::PreparedCamera(const ir::Camera& camera, std::uint32_t width, std::uint32_t height)
    : camera_(camera),
      width_(width),
      height_(height),
      half_pixel_(math::tan(camera.angle / 2) / height) {}

math::Vec3d PreparedCamera::toward(double x, double y) const {
    // Twice the distance from the middle, so that mirrored pixels get mirrored numbers exactly.
    const double right = (2 * x - width_) * half_pixel_;
    const double up = (height_ - 2 * y) * half_pixel_;
    return camera_.forward + (camera_.right * right + camera_.up * up);
}

CameraRay PreparedCamera::pinhole(double x, double y) const {
    return {camera_.center, math::normalize(toward(x, y))};
}

CameraRay PreparedCamera::through_lens(double x, double y, Uniform2 lens) const {
    if (!(camera_.focus_distance > 0)) return pinhole(x, y);
    const math::Vec2d place =
        camera_.blades >= 3 ? sample_polygon(lens, camera_.blades) : sample_disk(lens);
    const double radius = camera_.aperture / 2;
    const math::Vec3d offset = camera_.right * (radius * place.x) + camera_.up * (radius * place.y);
    return {camera_.center + offset,
            math::normalize(toward(x, y) - offset / camera_.focus_distance)};
}

}  // namespace cobble::renderer
