// SPDX-License-Identifier: MIT
// The order in which a pass takes the samples of a tile: all of a pixel, then those of the next.
#pragma once

#include <cstdint>

#include "renderer/sampling/sample_pass.hpp"
#include "renderer/tile/pixel_mask.hpp"
#include "renderer/tile/pixel_order.hpp"

namespace cobble::renderer {

/// Goes over the samples that a pass takes of a tile.
class SampleCursor {
  public:
    SampleCursor(const SamplePass& pass, const Tile& tile)
        : pass_(pass), tile_(tile), sample_(pass.first), found_(find_pixel(tile, 0)) {
        place_ = found_.place();
        skip();
    }

    [[nodiscard]] bool at_end() const { return pixel_ >= tile_.pixels(); }
    [[nodiscard]] PixelPlace place() const { return place_; }       ///< of the pixel
    [[nodiscard]] std::uint32_t sample() const { return sample_; }  ///< of the pixel's
    /// Those of the pixel that are still to come, this one among them.
    [[nodiscard]] std::uint32_t left() const { return pass_.first + pass_.count - sample_; }

    /// By `count` samples, at most left(). True if that was the last one of its pixel.
    bool advance(std::uint32_t count = 1) {
        sample_ += count;
        if (left() > 0) return false;
        sample_ = pass_.first;
        next_pixel();
        skip();
        return true;
    }

  private:
    void next_pixel() {
        ++pixel_;
        if (++found_.inside == found_.block.pixels()) {
            if (at_end()) return;
            found_ = find_pixel(tile_, pixel_);
        }
        place_ = found_.place();
    }
    void skip() {
        if (pass_.active == nullptr) return;
        while (!at_end() && !pass_.active->has(place_.x, place_.y)) next_pixel();
    }

    SamplePass pass_;
    Tile tile_;
    std::uint64_t pixel_ = 0;
    std::uint32_t sample_ = 0;
    PixelInBlock found_;
    PixelPlace place_;
};

}  // namespace cobble::renderer
