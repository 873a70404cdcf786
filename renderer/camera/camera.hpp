// SPDX-License-Identifier: MIT
// Where a sample of a pixel looks from, whither, and when.
#pragma once

#include <cstdint>

#include "ir/math/vec.hpp"
#include "ir/scene/scene.hpp"
#include "renderer/sampling/sobol.hpp"

namespace cobble::renderer {

/// World space, in double: narrowed once, when it becomes a ray of the scene.
struct CameraRay {
    math::Vec3d origin;
    math::Vec3d direction;  ///< unit
};

/// ir::Camera for a picture of a certain size.
class PreparedCamera {
  public:
    PreparedCamera(const ir::Camera& camera, std::uint32_t width, std::uint32_t height);

    /// Through the point (x, y) of the picture: pixels, (0, 0) the upper left corner, pixel centres
    /// at +0.5. Pixels are square; the camera's angle spans the picture's height.
    [[nodiscard]] CameraRay pinhole(double x, double y) const {
        return {center_, math::normalize(toward(x, y))};
    }

    /// What pinhole() normalises: one along the view axis.
    [[nodiscard]] math::Vec3d toward(double x, double y) const {
        // Twice the distance from the middle, so that mirrored pixels get mirrored numbers exactly.
        const double right = (2 * x - width_) * half_pixel_;
        const double up = (height_ - 2 * y) * half_pixel_;
        return forward_ + (right_ * right + up_ * up);
    }

    /// The same through a place on a thin lens that is chosen by `lens`: all rays of one (x, y)
    /// meet at the focus distance, measured along the view axis. Round or, with blades, a regular
    /// polygon in that circle. An aperture of 0 gives the bits of pinhole().
    [[nodiscard]] CameraRay through_lens(double x, double y, Uniform2 lens) const;

    /// In the shutter's interval; a shutter that opens and closes at once gives that time's bits.
    [[nodiscard]] double time(double u) const {
        return math::lerp(shutter_open_, shutter_close_, u);
    }
    [[nodiscard]] double time_open() const { return shutter_open_; }

  private:
    // Numbers of ir::Camera, so that a loop over pixels can keep them in registers.
    math::Vec3d center_, forward_, right_, up_;
    double aperture_, focus_distance_;
    std::uint32_t blades_;
    double shutter_open_, shutter_close_;
    double width_, height_;
    double half_pixel_;  ///< of the picture plane at distance 1
};

}  // namespace cobble::renderer
