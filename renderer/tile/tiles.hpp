// SPDX-License-Identifier: MIT
// How a picture is cut into tiles and tiles are dealt out to shards.
#pragma once

#include <vector>

#include "renderer/settings.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// The tiles of this shard, row by row from the top: squares of settings.tile_size from the
/// window's upper left corner, cut off at its other ends. Tile (column, row) belongs to shard
/// (column + row) modulo shard_count, so that each shard is spread over the picture. Over all
/// shards every pixel of the window is in exactly one tile. A tile size of 0 counts as 1; no more
/// than 2^22 tiles are made, by taking larger ones.
std::vector<Tile> make_tiles(const Settings& settings);

}  // namespace cobble::renderer
