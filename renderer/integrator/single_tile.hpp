// SPDX-License-Identifier: MIT
// The reference's way through a tile: one ray at a time, every sample of a pixel in order, then the
// next pixel, row by row.
#pragma once

#include <cstdint>

#include "renderer/integrator/trace.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

template <typename T>
class SingleTile final : public PausedWork {
  public:
    /// Both must outlive this.
    SingleTile(const ShadingScene<T>& scene, const Settings& settings, const Tile& tile);

    /// Goes on with `work`, whose tile is this one; true once it is done, false if stopped.
    bool run(TileWork& work, Film& film, StopCheck& stop);

  private:
    /// One sample to its end and into the pixel; false if stopped before that.
    bool finish_sample(TileWork& work, StopCheck& stop);

    const ShadingScene<T>* scene_;
    const Settings* settings_;
    PixelAccumulator sums_;
    SampleTrace<T> trace_;
    std::uint32_t sample_ = 0;  ///< the one on the trace, or the next one
};

}  // namespace cobble::renderer
