// SPDX-License-Identifier: MIT
// What was counted while tiles were traced, and the bad samples that are shown.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "renderer/tile/stats.hpp"
#include "renderer/tile/tile_renderer.hpp"

namespace cobble::renderer {

/// Sums over finished tiles; one a worker, so that nothing is shared while rays are traced.
struct alignas(64) Totals {
    Counters counters;
    StageTimes stages;
    std::uint64_t samples = 0;
    std::uint64_t bad_sample_count = 0;
    std::vector<BadSample> bad_samples;

    void add(const TileWork& work) {
        counters += work.counters;
        stages += work.clock.times();
        samples += work.samples_done;
        bad_sample_count += work.bad_sample_count;
        bad_samples.insert(bad_samples.end(), work.bad_samples.begin(), work.bad_samples.end());
        keep_first();
    }
    void add(const BadSample& bad) {
        bad_samples.push_back(bad);
        keep_first();
    }
    void add(const Totals& other) {
        counters += other.counters;
        stages += other.stages;
        samples += other.samples;
        bad_sample_count += other.bad_sample_count;
        bad_samples.insert(bad_samples.end(), other.bad_samples.begin(), other.bad_samples.end());
        keep_first();
    }

  private:
    /// Which ones are kept does not depend on the order of tiles: the first of the picture are
    /// among the first of their tile.
    void keep_first() {
        std::sort(bad_samples.begin(), bad_samples.end());
        if (bad_samples.size() > TileWork::kBadSamplesKept) {
            bad_samples.resize(TileWork::kBadSamplesKept);
        }
    }
};

}  // namespace cobble::renderer
