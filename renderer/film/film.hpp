// SPDX-License-Identifier: MIT
// Where finished pixels go.
#pragma once

#include <cstdint>

#include "renderer/film/accumulator.hpp"
#include "renderer/film/picture.hpp"
#include "renderer/settings.hpp"

namespace cobble::renderer {

/// The part of the picture that `settings` asks for: the crop clamped to the picture, or all of it.
/// Empty (x0 = x1 or y0 = y1) if they do not meet.
Crop window_of(const Settings& settings);

/// Planes over the window only, in single precision; optional planes take memory only if wanted.
/// Different pixels may be set from different threads at once.
class Film {
  public:
    explicit Film(const Settings& settings);

    [[nodiscard]] const Crop& window() const { return window_; }
    /// (x, y) in the whole picture, inside the window. A value too large for a float becomes the
    /// largest float, not infinity.
    void set_pixel(std::uint32_t x, std::uint32_t y, const Pixel& pixel);
    [[nodiscard]] const Picture& picture() const { return picture_; }

  private:
    Crop window_;
    Picture picture_;
};

}  // namespace cobble::renderer
