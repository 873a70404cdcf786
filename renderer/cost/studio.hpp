// SPDX-License-Identifier: MIT
// What the parts of a study share: the scene, the clock, and rendering.
#pragma once

#include <chrono>
#include <optional>

#include "renderer/cost/run.hpp"
#include "renderer/cost/study.hpp"

namespace cobble::renderer {

class Studio {
  public:
    Studio(const ir::Scene& scene, const Settings& settings, Scheduler& scheduler,
           const StudyOptions& options, const Interrupted& interrupted)
        : scene_(&scene),
          settings_(settings),
          scheduler_(&scheduler),
          options_(options),
          interrupted_(interrupted) {
        settings_.goal.reset();
        settings_.scrambles = 1;
        settings_.salts = 0;
        settings_.shard_count = 1;
        settings_.shard_index = 0;
    }

    [[nodiscard]] const ir::Scene& scene() const { return *scene_; }
    /// The picture's that is asked about.
    [[nodiscard]] const Settings& settings() const { return settings_; }
    [[nodiscard]] Settings settings(std::uint32_t samples) const {
        Settings result = settings_;
        result.samples = samples;
        return result;
    }
    [[nodiscard]] const StudyOptions& options() const { return options_; }
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }
    /// Whether that much of the time (0 to 1) is not over.
    [[nodiscard]] bool before(double part) const { return seconds() < part * options_.seconds; }

    [[nodiscard]] std::optional<Run> run(const Settings& settings) const {
        return renderer::run(*scene_, settings, *scheduler_, interrupted_);
    }

  private:
    const ir::Scene* scene_;
    Settings settings_;
    Scheduler* scheduler_;
    StudyOptions options_;
    Interrupted interrupted_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace cobble::renderer
