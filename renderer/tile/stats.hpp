// SPDX-License-Identifier: MIT
// What a render did, counted exactly and the same on every machine; only the seconds differ.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "frontend/source/span.hpp"
#include "renderer/estimate/achieved.hpp"
#include "renderer/scene/preparation_note.hpp"
#include "renderer/tile/counters.hpp"
#include "renderer/tile/stage_clock.hpp"

namespace cobble::renderer {

/// A sample that came out NaN or infinite: counted, located and left out of its pixel.
struct BadSample {
    std::uint32_t x = 0, y = 0, sample = 0;
    source::Span span;  ///< the object hit first; invalid if none

    /// In the order of the picture's pixels, then of their samples.
    [[nodiscard]] bool operator<(const BadSample& other) const {
        return std::tie(y, x, sample) < std::tie(other.y, other.x, other.sample);
    }
};

struct PhaseTime {
    std::string name;
    double seconds = 0;
    double processor_seconds = 0;  ///< of all threads of the program; 0: not measured
};

struct Stats {
    Counters counters;
    std::uint64_t bad_sample_count = 0;
    std::vector<BadSample> bad_samples;  ///< the first 16 in pixel order
    std::vector<PreparationNote> notes;  ///< what preparing the geometry cost, by object
    std::vector<PhaseTime> phases;
    std::uint32_t workers = 0;
    StageTimes stages;                 ///< with Settings::time_stages; else all 0
    std::uint64_t scene_bytes = 0;     ///< geometry, tree and textures as rendered
    std::optional<Achieved> achieved;  ///< once complete, if the render can tell
};

}  // namespace cobble::renderer
