// SPDX-License-Identifier: MIT
// Where finished pixels go.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/film/accumulator.hpp"
#include "renderer/film/picture.hpp"
#include "renderer/film/scramble_sums.hpp"
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

    /// From now on pixels are set once in each pass, and the picture is the mean over all: by
    /// scramble, of which there are so many. What was seen before is forgotten.
    /// With `squares` each pass takes one sample of a pixel, which is clamped to [0, 1].
    void begin_sums(std::uint32_t scrambles, bool squares = false);
    /// What comes is of this scramble; no pixel of the pass is done yet.
    void begin_pass(std::uint32_t scramble);
    /// Of the window, rows from the top; null without begin_sums().
    [[nodiscard]] const ScrambleSums* sums() const { return sums_ ? &*sums_ : nullptr; }
    [[nodiscard]] ScrambleSums* sums() { return sums_ ? &*sums_ : nullptr; }

    [[nodiscard]] Picture picture() const;

    /// A number for each pixel of the window, row by row, that is 0 until the pass has set it.
    [[nodiscard]] const std::vector<std::uint8_t>& done() const { return done_; }
    /// Puts back what they were of a film of the same settings: its picture, if it keeps no sums
    /// (those put themselves back), and what is done of the pass.
    void restore(Picture picture, std::vector<std::uint8_t> done);

  private:
    void show(std::size_t index, const Pixel& pixel, Picture& picture) const;
    [[nodiscard]] std::size_t index_of(std::uint32_t x, std::uint32_t y) const {
        return std::size_t{y - window_.y0} * (window_.x1 - window_.x0) + (x - window_.x0);
    }

    Crop window_;
    Picture picture_;
    std::optional<ScrambleSums> sums_;
    std::uint32_t scramble_ = 0;
    std::vector<std::uint8_t> done_;  ///< not bits, which threads would have to share
};

}  // namespace cobble::renderer
