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
    [[nodiscard]] CameraRay pinhole(double x, double y) const;

    /// The same through a place on a thin lens that is chosen by `lens`: all rays of one (x, y)
    /// meet at the focus distance, measured along the view axis. Round or, with blades, a regular
    /// polygon in that circle. An aperture of 0 gives the bits of pinhole().
    [[nodiscard]] CameraRay through_lens(double x, double y, Uniform2 lens) const;

    /// In the shutter's interval; a shutter that opens and closes at once gives that time's bits.
    [[nodiscard]] double time(double u) const {
        return math::lerp(camera_.shutter_open, camera_.shutter_close, u);
    }
    [[nodiscard]] double time_open() const { return camera_.shutter_open; }

  private:
    /// Not unit: one along the view axis.
    [[nodiscard]] math::Vec3d toward(double x, double y) const;

    ir::Camera camera_;
    double width_, height_;
    double half_pixel_;  ///< of the picture plane at distance 1
};

}  // namespace cobble::renderer
