// SPDX-License-Identifier: MIT
// Where finished pixels go.
#pragma once

#include <cstddef>
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
    /// The same of a pixel of which only the colour is wanted, and how many samples it took.
    void set_color(std::uint32_t x, std::uint32_t y, math::Vec3d color, std::uint32_t samples);
    [[nodiscard]] const Picture& picture() const { return picture_; }

  private:
    [[nodiscard]] std::size_t index_of(std::uint32_t x, std::uint32_t y) const {
        return std::size_t{y - window_.y0} * (window_.x1 - window_.x0) + (x - window_.x0);
    }

    Crop window_;
    Picture picture_;
};

}  // namespace cobble::renderer
