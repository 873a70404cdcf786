// SPDX-License-Identifier: MIT
// How many samples a time allows, told by pictures of few.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/cost/run.hpp"

namespace cobble::renderer {

/// What a picture is expected to take and to come to.
struct BudgetChoice {
    std::uint32_t samples = 0;  ///< a pixel, to be shared out among Settings::scrambles
    double seconds = 0;         ///< its preparation and rendering
    double rms = 0;             ///< as Achieved has it
    bool fits = true;           ///< false: even the fewest samples are expected to take longer
};

/// `seconds` are for trials and for the picture chosen. Pictures of few samples tell what a sample
/// takes and how large the error is, up to a twentieth of the time; then a part of the picture,
/// with up to half as many samples as the choice, tells how both go on: the error by a power of the
/// samples from 0.4 to 1.5. Nothing if interrupted. `settings.scrambles` is at least 2, and
/// `settings.shard_count` 1.
std::optional<BudgetChoice> choose_for_budget(const ir::Scene& scene, const Settings& settings,
                                              double seconds, Scheduler& scheduler,
                                              const Interrupted& interrupted);

}  // namespace cobble::renderer
