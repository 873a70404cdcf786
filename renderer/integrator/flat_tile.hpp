// SPDX-License-Identifier: MIT
// The fast way through a tile of a scene in which no ray goes on from a surface: samples in batches
// in their order, each batch from its camera rays to its colours before the next one begins.
#pragma once

#include <cstdint>

#include "renderer/film/film.hpp"
#include "renderer/integrator/batch_stages.hpp"
#include "renderer/integrator/camera_batch.hpp"
#include "renderer/integrator/trace.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// Memory: some 60 kB in single precision.
template <typename T>
class FlatTile final : public PausedWork {
  public:
    /// Scene and settings must outlive this. The scene's plan says so.
    FlatTile(const ShadingScene<T>& scene, const Settings& settings, const TileWork& work);

    /// Goes on with `work`, the one that this was made for; true once it is done, false if stopped.
    bool run(TileWork& work, Film& film, StopCheck& stop);

  private:
    void begin(TileWork& work);
    void land(TileWork& work, Film& film);
    bool add(std::size_t lane);
    void land_together(TileWork& work, Film& film);
    void land_one_by_one(TileWork& work, Film& film);

    const ShadingScene<T>* scene_;
    std::uint32_t samples_;  ///< a pixel, in this pass
    std::size_t most_;       ///< samples in a batch: whole pixels, if they are not too large
    bool only_color_;  ///< nothing else of a sample is wanted, nor can it be unsound by itself
    bool on_its_way_ = false;  ///< a batch is
    CameraBatch<T> camera_;
    BatchStages<T> batch_;
    const ColumnLoops<T>* loops_;
    PixelSums pixel_sums_;
    PixelAccumulator sums_;  ///< of the pixel that lands next
};

}  // namespace cobble::renderer
