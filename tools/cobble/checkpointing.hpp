// SPDX-License-Identifier: MIT
// `render --checkpoint`: what the render has done is put into a file now and then, so that a kill
// loses little of it.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "ir/scene/scene.hpp"
#include "renderer/job/render_job.hpp"
#include "renderer/settings.hpp"
#include "tools/driver/checkpoint.hpp"

namespace CLI {
class App;
}

namespace cobble {

struct CheckpointOptions {
    std::string path;  ///< empty: none is written
    double interval = 30;
    bool resume = false;
};

void add_checkpoint_options(CLI::App& sub, CheckpointOptions& options);

class Checkpointing {
  public:
    explicit Checkpointing(const CheckpointOptions& options) : options_(options) {}

    /// What speaks against the options before anything is read: a file that is there and would be
    /// overwritten, a folder that is not. "" or what is wrong.
    [[nodiscard]] std::string check() const;

    /// Starts the job, from the checkpoint if that is asked for and there is one. A job that is
    /// null could not be gone on with: why is in `problem`.
    struct Started {
        std::unique_ptr<renderer::RenderJob> job;
        std::string problem;
        bool resumed = false;  ///< from the checkpoint
        bool anew = false;     ///< it was to be resumed, and there is no checkpoint
    };
    Started start(const ir::Scene& scene, const renderer::Settings& settings,
                  renderer::Scheduler& scheduler);

    /// To be called between the steps of the job: writes the file if it is time to. If that fails,
    /// says so, once for each reason, and leaves the file as it was.
    void look_in(const renderer::RenderJob& job);

    /// Writes the file now. False if there is none to write, or it could not be: said then.
    bool save(const renderer::RenderJob& job);

    /// The render has ended, and its pictures are written.
    void remove() const;

    [[nodiscard]] const std::string& path() const { return options_.path; }

  private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] std::string write(const renderer::RenderJob& job) const;

    const CheckpointOptions& options_;
    driver::CheckpointNote note_;
    Clock::time_point last_;
    std::string said_;
};

}  // namespace cobble
