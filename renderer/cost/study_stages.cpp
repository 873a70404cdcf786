// SPDX-License-Identifier: MIT
#include <algorithm>

#include "renderer/cost/parts.hpp"

namespace cobble::renderer {

std::optional<StageBill> study_stages(const Studio& studio, std::uint32_t samples) {
    Settings settings = studio.settings(samples);
    settings.time_stages = true;
    const std::optional<Run> run = studio.run(settings);
    if (!run) return std::nullopt;
    StageBill bill;
    bill.samples = samples;
    bill.workers = run->stats.workers;
    bill.seconds = run->render_seconds;
    const StageTimes& times = run->stats.stages;
    for (std::size_t i = 0; i < kTimedStages; ++i) {
        if (times.seconds[i] == 0) continue;
        bill.stages.push_back({static_cast<TimedStage>(i), times.seconds[i]});
    }
    bill.waiting = std::max(bill.workers * bill.seconds - times.sum(), 0.0);
    return bill;
}

}  // namespace cobble::renderer
