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

/// Pixel `index` of the tile, from 0 to tile.pixels() - 1, each pixel once: blocks of 8 x 8 row by
/// row, inside them along a Z-shaped curve (Morton, 1966), so that any aligned 4, 16 or 64 of them
/// are a square. Blocks that the tile's lower or right end cuts off go row by row.
inline PixelPlace pixel_in_blocks(const Tile& tile, std::uint64_t index) {
    constexpr std::uint32_t kBlock = 8;
    const std::uint64_t width = tile.x1 - tile.x0;
    const std::uint32_t height = tile.y1 - tile.y0;
    const auto top = static_cast<std::uint32_t>(index / (width * kBlock)) * kBlock;
    index -= top * width;
    const std::uint32_t rows = std::min(kBlock, height - top);
    const std::uint64_t block = index / (std::uint64_t{kBlock} * rows);
    const auto left = static_cast<std::uint32_t>(block * kBlock);
    const auto inside = static_cast<std::uint32_t>(index - std::uint64_t{left} * rows);
    const auto columns = static_cast<std::uint32_t>(std::min<std::uint64_t>(kBlock, width - left));
    std::uint32_t x = inside % columns;
    std::uint32_t y = inside / columns;
    if (rows == kBlock && columns == kBlock) {
        x = (inside & 1U) | (inside >> 1U & 2U) | (inside >> 2U & 4U);
        y = (inside >> 1U & 1U) | (inside >> 2U & 2U) | (inside >> 3U & 4U);
    }
    return {tile.x0 + left + x, tile.y0 + top + y};
}

}  // namespace cobble::renderer
