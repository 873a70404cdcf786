// SPDX-License-Identifier: MIT
// The first rays of a tile's samples, batch by batch: pixels by blocks, all samples of one, then
// the next.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "renderer/integrator/column_loops.hpp"
#include "renderer/integrator/columns.hpp"
#include "renderer/integrator/ray_batch.hpp"
#include "renderer/integrator/stages.hpp"
#include "renderer/sampling/sampler.hpp"
#include "renderer/settings.hpp"
#include "renderer/tile/sample_cursor.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

template <typename T>
class CameraBatch {
  public:
    /// Both must outlive this.
    CameraBatch(const ShadingScene<T>& scene, const Settings& settings, const SamplePass& pass,
                const Tile& tile);

    /// Begins the next samples, `most` of them or as many as there are, but at most kBatchSize, and
    /// makes `rays` theirs, one stretch. The same batch each time: what all rays have in common
    /// stays in it.
    void begin(std::size_t most, RayBatch<T>& rays, Counters& counters);
    /// The same, but rays that are in columns are only there.
    void begin_in_columns(std::size_t most, RayBatch<T>& rays, Counters& counters);

    // Of the samples begun last, by their place in the batch.
    [[nodiscard]] PixelPlace place(std::size_t i) const {
        const PixelRun& run = run_of(i);
        return {run.x, run.y};
    }
    [[nodiscard]] std::uint32_t sample(std::size_t i) const {
        const PixelRun& run = run_of(i);
        return run.first + (static_cast<std::uint32_t>(i) - run.begin);
    }
    [[nodiscard]] Sampler sampler(std::size_t i) const {
        const PixelRun& run = run_of(i);
        return {pass_, run.x, run.y, sample(i)};
    }

  private:
    std::size_t choose_samples(std::size_t most);
    void place_in_pixels();
    /// The rays of the samples begun, as the plan's stage has them.
    using SendRays = void (CameraBatch::*)(RayBatch<T>& rays);
    static SendRays choose(RayStage stage);
    template <RayStage kStage>
    void send(RayBatch<T>& rays);
    void fill_common(RayBatch<T>& rays);
    [[nodiscard]] const PixelRun& run_of(std::size_t i) const { return columns_->runs[run_[i]]; }

    const ShadingScene<T>* scene_;
    const Settings* settings_;
    const ColumnLoops<T>* loops_;
    SamplePass pass_;
    SendRays send_;
    SampleCursor next_;
    std::unique_ptr<CameraColumns> columns_;
    std::array<std::uint8_t, kBatchSize> run_{};  ///< by place in the batch
    bool first_ = true;                           ///< nothing has begun yet
};

}  // namespace cobble::renderer
