// SPDX-License-Identifier: MIT
// The whole study of what accuracy costs on a scene: it renders it many times, in less than the
// time that it is given where it can, and reports what it saw.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "renderer/cost/report.hpp"
#include "renderer/cost/run.hpp"

namespace cobble::renderer {

struct StudyOptions {
    double seconds = 60;         ///< to be spent, about
    bool keep_pictures = false;  ///< of the rungs, and their error maps
    double pixels_per_degree = 67;
    bool light = false;  ///< pictures hold light, which a display would encode
};

/// Hears which part of the study begins, and which part of the time is over.
using StudyProgress = std::function<void(std::string_view part, double fraction)>;

/// `settings` are those of the picture that is asked about; their samples, scrambles and goal are
/// not read. Nothing if interrupted. The report's errors and rays do not depend on the machine, but
/// which numbers of samples are tried does: it depends on the time that they take.
std::optional<CostReport> study_cost(const ir::Scene& scene, const Settings& settings,
                                     Scheduler& scheduler, const StudyOptions& options,
                                     const Interrupted& interrupted, const StudyProgress& progress);

}  // namespace cobble::renderer
