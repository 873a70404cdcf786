// SPDX-License-Identifier: MIT
// A render as a resumable job: the command line, a server and a browser drive it the same way.
//
//   auto job = start_render(scene, settings, scheduler);
//   while (!job->step(now + 50ms).done) { show progress; if (stop) job->cancel(); }
//   Picture picture = job->picture();
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "ir/scene/scene.hpp"
#include "renderer/estimate/achieved.hpp"
#include "renderer/film/picture.hpp"
#include "renderer/film/scramble_sums.hpp"
#include "renderer/job/scheduler.hpp"
#include "renderer/settings.hpp"
#include "renderer/tile/stats.hpp"
#include "renderer/tile/stop.hpp"

namespace cobble::renderer {

struct Progress {
    bool done = false;                 ///< finished or cancelled
    double fraction = 0;               ///< of the samples, 0 to 1
    std::uint64_t rays = 0;            ///< traced so far, of all kinds
    double seconds = 0;                ///< spent in step() so far
    std::optional<Forecast> forecast;  ///< of a picture with an error to reach, once it has one
};

class RenderJob {
  public:
    RenderJob() = default;
    RenderJob(const RenderJob&) = delete;
    RenderJob& operator=(const RenderJob&) = delete;
    virtual ~RenderJob() = default;

    /// Works until `deadline` (overrun by at most 10 ms) or until done. The first steps prepare the
    /// scene: beside the steps where the scheduler has threads. Where it has none the first step
    /// does that and nothing else, and overruns its deadline by as long as it takes: about a second
    /// for a mesh of a million triangles. Cancelled meanwhile, by a signal or another thread, it
    /// ends within some 50 ms (measured for that mesh, most of it to give memory back).
    /// The last step of a picture that tells its error overruns by some 0.3 us a pixel, to sum it
    /// up. Results do not depend on deadlines, threads or tile size. Throws only if memory runs
    /// out: then what there is can still be read, but the job must take no other step.
    virtual Progress step(Deadline deadline) = 0;
    /// May be called from another thread or a signal handler; the running step returns soon.
    virtual void cancel() = 0;
    /// What there is so far; complete if the job ran to its end.
    [[nodiscard]] virtual Picture picture() const = 0;
    /// Of a job that was resumed, of all its runs: seconds add up, and so do the rays of pixels
    /// that were on their way when it was stopped, though they are traced again.
    [[nodiscard]] virtual Stats stats() const = 0;
    /// By scramble, of a render of several; null of another.
    [[nodiscard]] virtual const ScrambleSums* sums() const = 0;
    /// What is done, as bytes that resume_render() goes on from: the pixels that are finished in
    /// this pass, the sums of those before it, and what was counted. Pixels on their way are no
    /// part of it; nor, of a published program's picture, is a tile on its way in which a sample
    /// came out as no number, lest that be counted twice. Between steps only. Some 12 bytes for
    /// each pixel done, 44 with all extra pictures; for each pixel those of ScrambleSums in several
    /// passes.
    [[nodiscard]] virtual std::string state() const = 0;
};

/// `scene` and `scheduler` must outlive the job. Returns at once; all work happens in step().
std::unique_ptr<RenderJob> start_render(const ir::Scene& scene, const Settings& settings,
                                        Scheduler& scheduler);

struct Resumed {
    std::unique_ptr<RenderJob> job;
    std::string problem;  ///< why there is no job; else empty
};

/// The same, from where a job was whose state() this is. The picture is the one that it would have
/// become without the interruption, to the bit, whatever the threads, tiles and acceleration before
/// and after. Bytes that are no state of such a job are refused; that they are of the same scene
/// and settings, and unchanged, is for whoever kept them to see to. Of a picture with an error to
/// reach that was stopped between two rounds, all pixels are looked at before this returns.
Resumed resume_render(const ir::Scene& scene, const Settings& settings, Scheduler& scheduler,
                      std::string_view state);

}  // namespace cobble::renderer
