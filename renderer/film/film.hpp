// SPDX-License-Identifier: MIT
// Where finished pixels go.
#pragma once

#include <cstdint>

#include "renderer/film/accumulator.hpp"
#include "renderer/film/picture.hpp"
#include "renderer/settings.hpp"

namespace cobble::renderer {

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
