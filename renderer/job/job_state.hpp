// SPDX-License-Identifier: MIT
// What a render job has done so far, as bytes, and back: RenderJob::state() and resume_render().
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/film/picture.hpp"
#include "renderer/tile/stats.hpp"

namespace cobble::renderer {

/// What was counted on the way to some of a picture's pixels.
struct JobTally {
    Counters counters;
    StageTimes stages;
    std::uint64_t samples = 0;
    std::uint64_t bad_sample_count = 0;
    std::vector<BadSample> bad_samples;
    double seconds = 0, render_seconds = 0, render_processor_seconds = 0;
};

/// The film's, of a job of several passes.
struct SumsState {
    std::uint32_t scrambles = 0;
    bool squares = false;
    std::vector<std::uint8_t> bytes;  ///< ScrambleSums::bytes()
};

struct JobState {
    Picture planes;                  ///< of a job that keeps no sums
    std::vector<std::uint8_t> done;  ///< by pixel, row by row: 0 if it is not done in this pass
    std::vector<std::uint8_t> plan;  ///< PassPlan::bytes(), at this pass
    std::optional<SumsState> sums;
    JobTally tally;
};

/// A version number, then parts by name: the size of the planes, a bit a pixel that says which are
/// done, the plan, the sums or of each plane that is not empty the numbers of the pixels that are
/// done, and the tally. Of bad samples it keeps which of the scene's objects they are on: the same
/// scene may stand elsewhere in its file by the time the state is read.
std::string encode_state(const JobState& state, const ir::Scene& scene);

/// Reads what encode_state() wrote into a state whose planes are of the size and kind that they
/// should be of; pixels that are not done stay as they are. `scene` is the one that it is of.
/// `bytes` may be any: gives "" or what is wrong with them, and then has changed nothing.
std::string decode_state(std::string_view bytes, const ir::Scene& scene, JobState& state);

}  // namespace cobble::renderer
