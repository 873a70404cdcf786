// SPDX-License-Identifier: MIT
#include "tools/cobble/checkpointing.hpp"

#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <new>
#include <utility>

#include "tools/cobble/arguments.hpp"
#include "tools/driver/output.hpp"
#include "tools/driver/write_file.hpp"

namespace cobble {
namespace {

struct Found {
    bool there = false;
    bool is_file = false;  ///< and no device, descriptor or folder
    bool empty = false;
};

Found look_at(const std::string& path) {
    struct stat status {};
    if (lstat(driver::follow_links(path).c_str(), &status) != 0) return {};
    return {true, S_ISREG(status.st_mode), status.st_size == 0};
}

}  // namespace

void add_checkpoint_options(CLI::App& sub, CheckpointOptions& options) {
    const std::string group = "Long renders";
    sub.add_option("--checkpoint", options.path,
                   "Keep what is done in this file, so that a render that is interrupted or killed "
                   "can be gone on with; a render that ends removes it")
        ->type_name("FILE")
        ->group(group);
    require_number(sub.add_option("--checkpoint-interval", options.interval,
                                  "How often: a kill loses no more than that"),
                   0)
        ->type_name("SECONDS")
        ->capture_default_str()
        ->group(group);
    sub.add_flag("--resume", options.resume,
                 "Go on from the file of --checkpoint, or begin if it is not there; scene, options "
                 "and version must be those it was made with, but for --threads and --reference")
        ->group(group);
}

std::string Checkpointing::check() const {
    if (options_.path.empty()) return {};
    const Found found = look_at(options_.path);
    if (options_.path == "-" || (found.there && !found.is_file)) {
        return fmt::format("cannot write {}: a checkpoint is a regular file", options_.path);
    }
    // What hours were spent on is not overwritten because a word was forgotten.
    if (!options_.resume && found.there && !found.empty) {
        return fmt::format("{} is there already: add '--resume' to go on from it, or remove it",
                           options_.path);
    }
    return driver::check_place(options_.path);
}

Checkpointing::Started Checkpointing::start(const ir::Scene& scene,
                                            const renderer::Settings& settings,
                                            renderer::Scheduler& scheduler) {
    Started started;
    last_ = Clock::now();
    if (!options_.path.empty()) note_ = driver::checkpoint_note(scene, settings);
    if (options_.resume) {
        const driver::Checkpoint checkpoint = driver::read_checkpoint(options_.path, note_);
        started.problem = checkpoint.problem;
        started.anew = checkpoint.missing;
        if (!started.problem.empty()) return started;
        if (!checkpoint.missing) {
            renderer::Resumed resumed =
                renderer::resume_render(scene, settings, scheduler, checkpoint.state);
            started.job = std::move(resumed.job);
            started.resumed = started.job != nullptr;
            if (!resumed.problem.empty()) {
                started.problem =
                    fmt::format("cannot resume from {}: {}", options_.path, resumed.problem);
            }
            return started;
        }
    }
    started.job = renderer::start_render(scene, settings, scheduler);
    return started;
}

void Checkpointing::look_in(const renderer::RenderJob& job) {
    if (options_.path.empty()) return;
    const std::chrono::duration<double> since = Clock::now() - last_;
    if (since.count() < options_.interval) return;
    std::string problem = write(job);
    // After it, so that a slow disk does not take all of the time.
    last_ = Clock::now();
    if (!problem.empty() && problem != said_) {
        driver::complain(fmt::format("{}; the render goes on, and tries again in {:g} s", problem,
                                     options_.interval));
    }
    said_ = std::move(problem);
}

bool Checkpointing::save(const renderer::RenderJob& job) {
    if (options_.path.empty()) return false;
    const std::string problem = write(job);
    if (!problem.empty()) driver::complain(problem);
    return problem.empty();
}

void Checkpointing::remove() const {
    if (options_.path.empty() || !look_at(options_.path).is_file) return;
    unlink(driver::follow_links(options_.path).c_str());
}

std::string Checkpointing::write(const renderer::RenderJob& job) const {
    try {
        return driver::write_file(options_.path, driver::encode_checkpoint(note_, job.state()));
    } catch (const std::bad_alloc&) {
        return fmt::format("cannot write {}: there is no memory for it", options_.path);
    }
}

}  // namespace cobble
