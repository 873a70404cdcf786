// SPDX-License-Identifier: MIT
// The reference's way through a tile: one ray at a time, every sample of a pixel in order, then the
// next pixel.
#pragma once

#include <cstdint>

#include "renderer/integrator/trace.hpp"
#include "renderer/tile/sample_cursor.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

template <typename T>
class SingleTile final : public PausedWork {
  public:
    /// Scene and settings must outlive this.
    SingleTile(const ShadingScene<T>& scene, const Settings& settings, const TileWork& work);

    /// Goes on with `work`, the one that this was made for; true once it is done, false if stopped.
    bool run(TileWork& work, Film& film, StopCheck& stop);

  private:
    /// One sample to its end and into the pixel; false if stopped before that.
    bool finish_sample(TileWork& work, StopCheck& stop);

    const ShadingScene<T>* scene_;
    PixelFilter filter_;
    SampleCursor next_;  ///< the sample on the trace, or the next one
    PixelAccumulator sums_;
    SampleTrace<T> trace_;
};

}  // namespace cobble::renderer
