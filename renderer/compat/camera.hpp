// SPDX-License-Identifier: MIT
// Where the published programs' camera rays go.
#pragma once

#include <cstdint>

#include "ir/scene/scene.hpp"
#include "renderer/compat/rules.hpp"

namespace cobble::renderer {

/// The picture's edges are at -1 and 1 in both directions, whatever its shape: a picture that is
/// not square is stretched. The first and the last pixel lie on the edges.
class CompatCamera {
  public:
    struct Ray {
        math::Vec3d origin;     ///< world
        math::Vec3d direction;  ///< unit
    };

    CompatCamera(const ir::Camera& camera, const CompatRules& rules, std::uint32_t width,
                 std::uint32_t height);

    /// Sample (x, y) of the high-resolution picture (width x height times the rules' grid), y from
    /// the top; dx, dy in [-0.5, 0.5] move it by as many samples, dy upwards.
    [[nodiscard]] math::Vec3d direction(std::uint32_t x, std::uint32_t y, double dx,
                                        double dy) const;
    [[nodiscard]] Ray ray(math::Vec3d direction) const { return {center_, direction}; }
    /// Through a point of the lens (lens_x, lens_y in the unit disk), so that the plane at the
    /// rules' focus stays sharp.
    [[nodiscard]] Ray lens_ray(math::Vec3d direction, double lens_x, double lens_y) const;

  private:
    math::Vec3d center_, forward_, right_, up_, lens_up_;
    double distance_ = 1;  ///< of the picture's plane, whose half height is 1
    double columns_ = 1, rows_ = 1;
    std::uint32_t last_row_ = 0;
    double focus_ = 1;
    double lens_radius_ = 0;
};

}  // namespace cobble::renderer
