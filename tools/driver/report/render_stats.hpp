// SPDX-License-Identifier: MIT
// What a render cost, as JSON and in words.
#pragma once

#include <string>

#include "frontend/source/source_map.hpp"
#include "renderer/job/render_job.hpp"
#include "renderer/settings.hpp"
#include "renderer/tile/stats.hpp"
#include "tools/driver/load.hpp"

namespace cobble::driver {

struct RenderStats {
    const LoadedScene& loaded;
    const renderer::Settings& settings;
    const renderer::Stats& stats;
    const renderer::Progress& progress;
    bool complete = true;
    double write_seconds = 0;
};

/// {"cobble_stats": 1, "picture": ..., "accuracy": the error, "phases": [{"name", "seconds"}],
/// "stages": the same, of all "workers" together while they rendered, "rays": by kind, "tests",
/// "memory": bytes, "notes":
/// [{"kind", "object", "count", "message"}] of what preparing the geometry cost, "bad_samples":
/// ...}, and a line end. Fields are only ever added.
std::string stats_to_json(const RenderStats& stats);

/// "3 samples came out infinite or not a number ...", with the place of the first.
std::string bad_sample_text(const renderer::Stats& stats, const source::SourceMap& sources);

}  // namespace cobble::driver
