// SPDX-License-Identifier: MIT
#include "renderer/tile/tiles.hpp"

#include <algorithm>

#include "renderer/film/film.hpp"

namespace cobble::renderer {

std::vector<Tile> make_tiles(const Settings& settings) {
    const Crop window = window_of(settings);
    const std::uint64_t width = window.x1 - window.x0;
    const std::uint64_t height = window.y1 - window.y0;
    if (width == 0 || height == 0) return {};
    const std::uint64_t shards = std::max(settings.shard_count, 1U);
    std::uint64_t size = std::max(settings.tile_size, 1U);
    constexpr std::uint64_t kMostTiles = std::uint64_t{1} << 22U;
    while (((width + size - 1) / size) * ((height + size - 1) / size) > kMostTiles) size *= 2;

    std::vector<Tile> tiles;
    for (std::uint64_t top = 0, row = 0; top < height; top += size, ++row) {
        for (std::uint64_t left = 0, column = 0; left < width; left += size, ++column) {
            if ((column + row) % shards != settings.shard_index) continue;
            const auto x = [&](std::uint64_t at) {
                return window.x0 + static_cast<std::uint32_t>(std::min(at, width));
            };
            const auto y = [&](std::uint64_t at) {
                return window.y0 + static_cast<std::uint32_t>(std::min(at, height));
            };
            tiles.push_back({x(left), y(top), x(left + size), y(top + size)});
        }
    }
    return tiles;
}

}  // namespace cobble::renderer
