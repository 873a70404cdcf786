// SPDX-License-Identifier: MIT
// An order of a tile's pixels in which neighbours stay together, so that rays traced together go
// nearly alike.
#pragma once

#include <algorithm>
#include <cstdint>

#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// In the whole picture.
struct PixelPlace {
    std::uint32_t x = 0, y = 0;
};

/// A block of the tile, at most 8 x 8.
struct PixelBlock {
    PixelPlace corner;
    std::uint32_t columns = 0, rows = 0;

    [[nodiscard]] std::uint32_t pixels() const { return columns * rows; }
    /// Pixel `inside` of the block, below pixels().
    [[nodiscard]] PixelPlace place(std::uint32_t inside) const {
        if (rows != kSide || columns != kSide) {
            return {corner.x + inside % columns, corner.y + inside / columns};
        }
        return {corner.x + ((inside & 1U) | (inside >> 1U & 2U) | (inside >> 2U & 4U)),
                corner.y + ((inside >> 1U & 1U) | (inside >> 2U & 2U) | (inside >> 3U & 4U))};
    }

    static constexpr std::uint32_t kSide = 8;
};

/// Where a pixel is found: in a block, as its pixel `inside`.
struct PixelInBlock {
    PixelBlock block;
    std::uint32_t inside = 0;

    [[nodiscard]] PixelPlace place() const { return block.place(inside); }
};

/// Pixel `index` of the tile, from 0 to tile.pixels() - 1, each pixel once: blocks of 8 x 8 row by
/// row, inside them along a Z-shaped curve (Morton, 1966), so that any aligned 4, 16 or 64 of them
/// are a square. Blocks that the tile's lower or right end cuts off go row by row.
inline PixelInBlock find_pixel(const Tile& tile, std::uint64_t index) {
    constexpr std::uint32_t kSide = PixelBlock::kSide;
    const std::uint64_t width = tile.x1 - tile.x0;
    const std::uint32_t height = tile.y1 - tile.y0;
    const auto top = static_cast<std::uint32_t>(index / (width * kSide)) * kSide;
    index -= top * width;
    const std::uint32_t rows = std::min(kSide, height - top);
    const std::uint64_t block = index / (std::uint64_t{kSide} * rows);
    const auto left = static_cast<std::uint32_t>(block * kSide);
    const auto inside = static_cast<std::uint32_t>(index - std::uint64_t{left} * rows);
    const auto columns = static_cast<std::uint32_t>(std::min<std::uint64_t>(kSide, width - left));
    return {{{tile.x0 + left, tile.y0 + top}, columns, rows}, inside};
}

inline PixelPlace pixel_in_blocks(const Tile& tile, std::uint64_t index) {
    return find_pixel(tile, index).place();
}

}  // namespace cobble::renderer
