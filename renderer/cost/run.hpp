// SPDX-License-Identifier: MIT
// One render for the sake of its figures.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "ir/scene/scene.hpp"
#include "renderer/film/scramble_sums.hpp"
#include "renderer/job/render_job.hpp"
#include "renderer/job/scheduler.hpp"
#include "renderer/settings.hpp"

namespace cobble::renderer {

/// Asked between steps of 50 ms whether to stop.
using Interrupted = std::function<bool()>;

struct Run {
    Picture picture;
    Stats stats;
    std::optional<ScrambleSums> sums;  ///< of a render of several scrambles
    double prepare_seconds = 0;
    double render_seconds = 0;

    [[nodiscard]] double seconds() const { return prepare_seconds + render_seconds; }
};

/// To the end, or nothing if interrupted.
std::optional<Run> run(const ir::Scene& scene, const Settings& settings, Scheduler& scheduler,
                       const Interrupted& interrupted);

}  // namespace cobble::renderer
