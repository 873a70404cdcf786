// SPDX-License-Identifier: MIT
#include "renderer/compat/camera.hpp"

#include "ir/math/elementary.hpp"

namespace cobble::renderer {
namespace {

/// Diameter of the project's lens as a part of the distance that is sharp. The original's lens is
/// not on record; this one blurs a thing at twice the distance by a fortieth of that distance.
constexpr double kLensPart = 0.05;

}  // namespace

CompatCamera::CompatCamera(const ir::Camera& camera, const CompatRules& rules, std::uint32_t width,
                           std::uint32_t height)
    : center_(camera.center),
      forward_(camera.forward),
      right_(camera.right),
      up_(rules.up_as_written ? camera.up_as_written : camera.up),
      lens_up_(camera.up),
      distance_(1 / math::tan(camera.angle / 2)),
      // A picture of one sample would divide by zero: it shows the left or bottom edge.
      columns_(width * rules.grid > 1 ? width * rules.grid - 1.0 : 1.0),
      rows_(height * rules.grid > 1 ? height * rules.grid - 1.0 : 1.0),
      last_row_(height * rules.grid - 1) {
    if (rules.focus && *rules.focus > 0) {
        focus_ = *rules.focus;
        lens_radius_ = (camera.aperture > 0 ? camera.aperture : kLensPart * focus_) / 2;
    }
}

math::Vec3d CompatCamera::direction(std::uint32_t x, std::uint32_t y, double dx, double dy) const {
    const double across = 2 * (x + dx) / columns_ - 1;
    const double upwards = 2 * ((last_row_ - y) + dy) / rows_ - 1;
    return math::normalize((across * right_ + upwards * up_) + distance_ * forward_);
}

CompatCamera::Ray CompatCamera::lens_ray(math::Vec3d direction, double lens_x,
                                         double lens_y) const {
    const math::Vec3d offset =
        (lens_x * lens_radius_) * right_ + (lens_y * lens_radius_) * lens_up_;
    const math::Vec3d focus = direction * (focus_ / math::dot(direction, forward_));
    return {center_ + offset, math::normalize(focus - offset)};
}

}  // namespace cobble::renderer
