// SPDX-License-Identifier: MIT
// What computes pixels, as the render job sees it: one tile at a time, resumable anywhere.
//
// The job owns threads, order, deadlines and sums; a TileRenderer owns what a pixel is. Cobble's
// own meaning (renderer/integrator) and the published programs' (renderer/compat) are two of them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/film/film.hpp"
#include "renderer/sampling/sample_pass.hpp"
#include "renderer/tile/stage_clock.hpp"
#include "renderer/tile/stats.hpp"
#include "renderer/tile/stop.hpp"

namespace cobble::renderer {

/// Pixels [x0, x1) x [y0, y1) of the whole picture, y downwards.
struct Tile {
    std::uint32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    [[nodiscard]] std::uint64_t pixels() const { return std::uint64_t{x1 - x0} * (y1 - y0); }
    [[nodiscard]] std::uint32_t x(std::uint64_t pixel) const {
        return x0 + static_cast<std::uint32_t>(pixel % (x1 - x0));
    }
    [[nodiscard]] std::uint32_t y(std::uint64_t pixel) const {
        return y0 + static_cast<std::uint32_t>(pixel / (x1 - x0));
    }
};

/// Whatever a renderer must remember to go on in the middle of a tile.
class PausedWork {
  public:
    PausedWork() = default;
    PausedWork(const PausedWork&) = delete;
    PausedWork& operator=(const PausedWork&) = delete;
    virtual ~PausedWork() = default;
};

/// A tile on its way. Used by one worker at a time, but not always by the same one.
struct TileWork {
    Tile tile;
    SamplePass pass;
    std::uint64_t pixels = 0;       ///< of the tile that the pass asks for
    std::uint64_t pixels_done = 0;  ///< of those, in whatever order the renderer takes them
    std::unique_ptr<PausedWork> paused;
    std::uint64_t samples_done = 0;
    Counters counters;
    StageClock clock{false};
    std::uint64_t bad_sample_count = 0;
    std::uint64_t bad_of_done = 0;       ///< those of pixels that are done, by end_pixels()
    std::vector<BadSample> bad_samples;  ///< the first kBadSamplesKept of the tile, in their order

    static constexpr std::size_t kBadSamplesKept = 16;

    [[nodiscard]] bool done() const { return pixels_done == pixels; }
    /// So many are done, and all samples reported so far are theirs or of pixels before them.
    void end_pixels(std::uint64_t count = 1) {
        pixels_done += count;
        bad_of_done = bad_sample_count;
    }
    void report(const BadSample& bad) {
        ++bad_sample_count;
        bad_samples.insert(std::upper_bound(bad_samples.begin(), bad_samples.end(), bad), bad);
        if (bad_samples.size() > kBadSamplesKept) bad_samples.pop_back();
    }
};

class TileRenderer {
  public:
    TileRenderer() = default;
    TileRenderer(const TileRenderer&) = delete;
    TileRenderer& operator=(const TileRenderer&) = delete;
    virtual ~TileRenderer() = default;

    /// Goes on with `work` until it is done or `stop` says so: then it returns within about 10 ms,
    /// having left in `work` what it needs to go on without a trace of the interruption. Gives each
    /// finished pixel to `film` once. Called by several workers at once, on different tiles.
    /// Throws nothing but std::bad_alloc. Rounding is to nearest and denormals are kept while it
    /// runs.
    virtual void render_tile(TileWork& work, Film& film, StopCheck& stop) const = 0;

    /// What preparing the scene's geometry cost it.
    [[nodiscard]] virtual const std::vector<PreparationNote>& notes() const = 0;
};

}  // namespace cobble::renderer
