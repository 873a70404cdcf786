// SPDX-License-Identifier: MIT
// The fast way through a tile of a scene in which rays go on from surfaces: many samples on their
// way at once, each with its own stack.
//
// A round: samples that ended make room for new ones; the top rays of all stacks are sorted by the
// turns that led to them, so that those of neighbouring samples that went the same way lie side by
// side, and go in batches through the stages. Each ray brings back its colour and puts its children
// on its own stack. Within a sample everything is added in the order of the reference, and samples
// are added to their pixels in the order of the samples, so that the pictures are the same bits.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/film/film.hpp"
#include "renderer/integrator/batch_stages.hpp"
#include "renderer/integrator/camera_batch.hpp"
#include "renderer/integrator/trace.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// Memory: about 1 kB for each sample on its way, 80 bytes more a bounce, and eight times 104 bytes
/// for those that wait for it; in single precision.
template <typename T>
class BatchedTile final : public PausedWork {
  public:
    /// Both must outlive this.
    BatchedTile(const ShadingScene<T>& scene, const Settings& settings, const Tile& tile);

    /// Goes on with `work`, whose tile is this one; true once it is done, false if stopped.
    bool run(TileWork& work, Film& film, StopCheck& stop);

  private:
    /// A sample on its way.
    struct Flight {
        SampleTrace<T> trace;
        Sampler sampler{0, 0, 0, 0};
        std::uint64_t number = 0;  ///< among the tile's samples
    };
    /// A sample at its end, which may have to wait for earlier ones.
    struct Landed {
        Sample sample;
        ir::ObjectId first_object;
        bool there = false;
    };

    void gather(TileWork& work);
    void begin_samples(const Tile& tile);
    void sort_round();
    void scatter_all();
    void land(TileWork& work, Film& film);
    [[nodiscard]] Flight& flight(std::size_t lane) { return flights_[round_[first_ + lane]]; }

    const ShadingScene<T>* scene_;
    const Settings* settings_;
    bool only_color_;
    std::uint32_t samples_;  ///< a pixel

    std::vector<Flight> flights_;
    std::vector<std::uint32_t> idle_;  ///< flights without a sample
    std::vector<std::uint32_t> next_;  ///< the others, for the next round
    std::vector<std::uint32_t> round_;
    std::size_t first_ = 0;  ///< of the round: where the batch begins
    CameraBatch<T> camera_;
    RayBatch<T> begun_;  ///< by it

    bool on_its_way_ = false;  ///< a batch is
    BatchStages<T> batch_;

    std::vector<Landed> landed_;  ///< by number, modulo their count
    SampleCursor next_to_land_;
    PixelAccumulator sums_;  ///< of the pixel that lands next
};

}  // namespace cobble::renderer
