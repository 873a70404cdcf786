// SPDX-License-Identifier: MIT
#include "renderer/cost/run.hpp"

#include <chrono>

namespace cobble::renderer {

std::optional<Run> run(const ir::Scene& scene, const Settings& settings, Scheduler& scheduler,
                       const Interrupted& interrupted) {
    constexpr std::chrono::milliseconds kStep{50};
    const auto job = start_render(scene, settings, scheduler);
    bool done = false;
    while (!done) {
        if (interrupted()) return std::nullopt;
        done = job->step(std::chrono::steady_clock::now() + kStep).done;
    }
    if (interrupted()) return std::nullopt;
    Run result;
    result.picture = job->picture();
    if (!result.picture.complete) return std::nullopt;
    result.stats = job->stats();
    if (const ScrambleSums* sums = job->sums()) result.sums = *sums;
    for (const PhaseTime& phase : result.stats.phases) {
        (phase.name == "prepare" ? result.prepare_seconds : result.render_seconds) += phase.seconds;
    }
    return result;
}

}  // namespace cobble::renderer
