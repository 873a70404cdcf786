// SPDX-License-Identifier: MIT
// Some of the pixels of a picture's window.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "renderer/settings.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// A byte a pixel, so that different pixels may be set from different threads at once.
class PixelMask {
  public:
    PixelMask(const Crop& window, bool all)
        : window_(window),
          bytes_(std::size_t{window.x1 - window.x0} * (window.y1 - window.y0), all ? 1 : 0) {}

    // (x, y) in the whole picture, inside the window.
    [[nodiscard]] std::size_t index_of(std::uint32_t x, std::uint32_t y) const {
        return std::size_t{y - window_.y0} * (window_.x1 - window_.x0) + (x - window_.x0);
    }
    [[nodiscard]] bool has(std::uint32_t x, std::uint32_t y) const {
        return bytes_[index_of(x, y)] != 0;
    }
    void set(std::uint32_t x, std::uint32_t y, bool in) { bytes_[index_of(x, y)] = in ? 1 : 0; }

    /// Rows from the top of the window; 1 where a pixel is in.
    [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }
    [[nodiscard]] std::vector<std::uint8_t>& bytes() { return bytes_; }

    [[nodiscard]] std::uint64_t count() const {
        return static_cast<std::uint64_t>(std::count(bytes_.begin(), bytes_.end(), 1));
    }
    [[nodiscard]] std::uint64_t count_in(const Tile& tile) const {
        std::uint64_t sum = 0;
        for (std::uint32_t y = tile.y0; y < tile.y1; ++y) {
            const auto row = bytes_.begin() + static_cast<std::ptrdiff_t>(index_of(tile.x0, y));
            sum += static_cast<std::uint64_t>(std::count(row, row + (tile.x1 - tile.x0), 1));
        }
        return sum;
    }

  private:
    Crop window_;
    std::vector<std::uint8_t> bytes_;
};

}  // namespace cobble::renderer
