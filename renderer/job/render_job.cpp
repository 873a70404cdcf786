// SPDX-License-Identifier: MIT
#include "renderer/job/render_job.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <tuple>
#include <utility>

#include "renderer/compat/compat_renderer.hpp"
#include "renderer/film/film.hpp"
#include "renderer/integrator/scene_renderer.hpp"
#include "renderer/job/build_on.hpp"
#include "renderer/job/fp_environment.hpp"
#include "renderer/job/job_state.hpp"
#include "renderer/job/totals.hpp"
#include "renderer/passes/pass_plan.hpp"
#include "renderer/tile/pixel_mask.hpp"
#include "renderer/tile/tile_renderer.hpp"
#include "renderer/tile/tiles.hpp"

namespace cobble::renderer {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

template <typename T>
std::unique_ptr<TileRenderer> prepare_renderer(const ir::Scene& scene, const Settings& settings,
                                               const BuildControl& build, std::uint64_t& bytes) {
    auto renderer =
        std::make_unique<SceneRenderer<T>>(prepare_shading<T>(scene, settings, build), settings);
    bytes = renderer->scene().bytes();
    return renderer;
}

/// A published program takes as many samples as its flags say, in one pass.
Settings as_traced(const ir::Scene& scene, Settings settings) {
    if (scene.compat == ir::Compat::kNone) return settings;
    settings.samples = compat_samples_per_pixel(scene, settings);
    settings.scrambles = 1;
    settings.goal.reset();
    return settings;
}

std::uint64_t bytes_of_images(const ir::Scene& scene) {
    std::uint64_t bytes = 0;
    for (const ir::Image& image : scene.images) {
        bytes += image.bytes.size() + image.floats.size() * sizeof(float);
    }
    return bytes;
}

class Job final : public RenderJob {
  public:
    Job(const ir::Scene& scene, const Settings& settings, Scheduler& scheduler)
        : scene_(&scene),
          settings_(settings),
          scheduler_(&scheduler),
          film_(settings),
          tiles_(make_tiles(settings)),
          plan_(make_plan(as_traced(scene, settings), tiles_)),
          in_hand_(scheduler.workers()),
          totals_(scheduler.workers()),
          left_(film_.window(), false) {
        begin_pass();
    }

    /// Before the first step. Gives "" or what is wrong with the state.
    std::string restore(std::string_view bytes) {
        JobState state;
        state.planes = film_.picture();
        std::string problem = decode_state(bytes, *scene_, state);
        if (!problem.empty()) return problem;
        seconds_ = state.tally.seconds;
        render_seconds_before_ = state.tally.render_seconds;
        render_processor_seconds_ = state.tally.render_processor_seconds;
        if (!tiles_.empty() && !go_on_with(state)) {
            return "its state is of another way to take samples";
        }
        before_.counters = state.tally.counters;
        before_.stages = state.tally.stages;
        before_.samples = state.tally.samples;
        before_.bad_sample_count = state.tally.bad_sample_count;
        before_.bad_samples = std::move(state.tally.bad_samples);
        return {};
    }

    Progress step(Deadline deadline) override {
        const Clock::time_point start = Clock::now();
        if (!complete_ && !cancelled()) {
            if (prepared(deadline)) {
                step_start_ = Clock::now();
                const std::clock_t processor_start = std::clock();
                render_until(deadline);
                steps_seconds_ += seconds_since(*step_start_);
                step_start_.reset();
                render_processor_seconds_ +=
                    static_cast<double>(std::clock() - processor_start) / CLOCKS_PER_SEC;
            }
        }
        seconds_ += seconds_since(start);
        return progress();
    }

    ~Job() override { cancel_now(); }

    void cancel() override { cancel_now(); }

    [[nodiscard]] Picture picture() const override {
        Picture result = film_.picture();
        result.complete = complete_;
        return result;
    }

    [[nodiscard]] Stats stats() const override {
        const Totals sum = total();
        Stats stats;
        stats.counters = sum.counters;
        stats.bad_sample_count = sum.bad_sample_count;
        stats.bad_samples = sum.bad_samples;
        // Until it has ended, the preparation's figures are still being written.
        stats.phases = {{"prepare", prepared_ ? prepare_seconds_ : 0, 0},
                        {"render", render_seconds(), render_processor_seconds_}};
        stats.workers = scheduler_->workers();
        stats.stages = sum.stages;
        stats.scene_bytes = prepared_ ? bytes_ : 0;
        if (prepared_) stats.notes = renderer_->notes();
        stats.achieved = plan_->achieved();
        return stats;
    }

    [[nodiscard]] const ScrambleSums* sums() const override { return film_.sums(); }
    [[nodiscard]] std::string state() const override {
        JobState state;
        state.planes = film_.picture();
        state.done = film_.done();
        state.plan = complete_ ? last_plan_ : plan_->bytes();
        if (const ScrambleSums* sums = film_.sums()) {
            state.sums = {sums->scrambles(), sums->has_squares(), sums->bytes()};
        }
        Totals sum = finished();
        for (const auto& work : in_hand_) {
            if (work != nullptr) add_done_of(*work, sum, state.done);
        }
        state.tally = {sum.counters,    sum.stages, sum.samples,      sum.bad_sample_count,
                       sum.bad_samples, seconds_,   render_seconds(), render_processor_seconds_};
        return encode_state(state, *scene_);
    }

  private:
    [[nodiscard]] double render_seconds() const { return render_seconds_before_ + steps_seconds_; }
    /// That of the step that goes on too.
    [[nodiscard]] double render_seconds_now() const {
        return render_seconds() + (step_start_ ? seconds_since(*step_start_) : 0);
    }

    /// What a tile on its way adds to a state: its finished pixels, and all rays.
    void add_done_of(const TileWork& work, Totals& sum, std::vector<std::uint8_t>& done) const {
        sum.counters += work.counters;
        sum.stages += work.clock.times();
        // A published program's samples are taken ahead of their pixels: whose the bad ones are is
        // not known. Such a tile begins anew.
        if (work.bad_sample_count > 0 && scene_->compat != ir::Compat::kNone) {
            each_pixel(work.tile, [&](std::size_t i) {
                if (work.pass.active == nullptr || work.pass.active->bytes()[i] != 0) done[i] = 0;
            });
            return;
        }
        sum.samples += work.pixels_done * work.pass.count;
        sum.bad_sample_count += work.bad_of_done;
        // Those of the pixel on its way come again, and whatever they have pushed out stays out.
        for (const BadSample& bad : work.bad_samples) {
            if (done[left_.index_of(bad.x, bad.y)] != 0) sum.add(bad);
        }
    }

    template <typename Visit>
    void each_pixel(const Tile& tile, const Visit& visit) const {
        for (std::uint32_t y = tile.y0; y < tile.y1; ++y) {
            for (std::uint32_t x = tile.x0; x < tile.x1; ++x) visit(left_.index_of(x, y));
        }
    }

    /// Begins the state's pass with the pixels of it that are left. False if it is none of the
    /// plan's.
    bool go_on_with(JobState& state) {
        const FpEnvironment environment;
        if (!plan_->restore(state.plan)) return false;
        if (state.sums.has_value() != (film_.sums() != nullptr)) return false;
        if (state.sums) {
            // No more memory than there are bytes.
            constexpr std::size_t kBytesOfScramble = sizeof(math::Vec3d) + sizeof(std::uint32_t);
            const std::size_t most = state.sums->bytes.size() / state.done.size();
            if (state.sums->scrambles == 0 || state.sums->scrambles > most / kBytesOfScramble) {
                return false;
            }
            film_.begin_sums(state.sums->scrambles, state.sums->squares);
            if (!film_.sums()->restore(state.sums->bytes)) return false;
        }
        begin_pass();
        if (complete_) return false;
        for (const Tile& tile : tiles_) {
            each_pixel(tile, [&](std::size_t i) {
                const bool asked = pass_.active == nullptr || pass_.active->bytes()[i] != 0;
                left_.bytes()[i] = asked && state.done[i] == 0 ? 1 : 0;
            });
        }
        film_.restore(std::move(state.planes), std::move(state.done));
        pass_.active = &left_;
        if (left_.count() > 0) return true;
        while (const std::uint32_t parts = plan_->due(film_)) {
            for (std::uint32_t part = 0; part < parts; ++part) plan_->work_out(part);
        }
        begin_pass();
        return true;
    }

    [[nodiscard]] bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

    void cancel_now() { cancelled_.store(true, std::memory_order_relaxed); }

    /// Whether rays can be traced by `deadline`. Trees are not built in steps: they are built
    /// beside the steps, which wait for them as long as they may.
    bool prepared(Deadline deadline) {
        if (prepared_) return true;
        if (preparation_ == nullptr) {
            preparation_ = scheduler_->start([this] { prepare_all(); });
        }
        // Short waits, so that a cancelled job is noticed.
        constexpr std::chrono::milliseconds kWait{20};
        while (!preparation_->wait_until(std::min(deadline, Clock::now() + kWait))) {
            if (cancelled() || Clock::now() >= deadline) return false;
        }
        prepared_ = !cancelled();
        // Where that was a step of its own, it is not to be made longer by rays.
        return prepared_ && Clock::now() < deadline;
    }

    void prepare_all() {
        const FpEnvironment environment;
        const Clock::time_point start = Clock::now();
        if (scene_->compat != ir::Compat::kNone) {
            renderer_ = make_compat_renderer(*scene_, settings_, bytes_, &cancelled_);
        } else {
            const BuildControl build = build_on(*scheduler_, &cancelled_);
            renderer_ = settings_.precision == Precision::kDouble
                            ? prepare_renderer<double>(*scene_, settings_, build, bytes_)
                            : prepare_renderer<float>(*scene_, settings_, build, bytes_);
        }
        bytes_ += bytes_of_images(*scene_);
        prepare_seconds_ = seconds_since(start);
    }

    /// Goes on with the pass, and with those after it.
    void render_until(Deadline deadline) {
        while (!complete_) {
            if (!pass_over_) {
                scheduler_->run([&](std::uint32_t worker) { work(worker, deadline); });
                pass_over_ = next_tile_.load(std::memory_order_relaxed) >= tiles_.size() &&
                             std::all_of(in_hand_.begin(), in_hand_.end(),
                                         [](const auto& tile) { return tile == nullptr; });
            }
            if (!pass_over_ || !look(deadline)) return;
            begin_pass();
            if (cancelled() || Clock::now() >= deadline) return;
        }
    }

    /// Between passes: works out what the plan asks for. False if there was no time for it all.
    bool look(Deadline deadline) {
        while (true) {
            if (next_part_.load(std::memory_order_relaxed) >= parts_) {
                parts_ = plan_->due(film_);
                next_part_.store(0, std::memory_order_relaxed);
                if (parts_ == 0) return true;
            }
            scheduler_->run([&](std::uint32_t worker) { work_out(worker, deadline); });
            if (next_part_.load(std::memory_order_relaxed) < parts_) return false;
        }
    }

    void work_out(std::uint32_t worker, Deadline deadline) {
        const FpEnvironment environment;
        StopCheck stop(cancelled_, deadline);
        StageClock clock(settings_.time_stages);
        clock.go_on();
        clock.enter(TimedStage::kErrors);
        do {
            const std::uint32_t part = next_part_.fetch_add(1, std::memory_order_relaxed);
            if (part >= parts_) break;
            plan_->work_out(part);
        } while (!stop.now());
        clock.pause();
        totals_[worker].stages += clock.times();
    }

    /// The next one; if there is none the picture is complete.
    void begin_pass() {
        const FpEnvironment environment;
        if (begun_) last_plan_ = plan_->bytes();
        begun_ = true;
        const std::optional<Pass> pass =
            tiles_.empty() ? std::nullopt : plan_->next(film_, render_seconds_now());
        complete_ = !pass.has_value();
        if (complete_) return;
        pass_ = pass->samples;
        pass_over_ = false;
        film_.begin_pass(pass->scramble);
        next_tile_.store(0, std::memory_order_relaxed);
    }

    /// The next tile of the pass in which there is something to do.
    std::unique_ptr<TileWork> take_tile() {
        while (true) {
            const std::size_t next = next_tile_.fetch_add(1, std::memory_order_relaxed);
            if (next >= tiles_.size()) return nullptr;
            const Tile& tile = tiles_[next];
            const std::uint64_t pixels =
                pass_.active == nullptr ? tile.pixels() : pass_.active->count_in(tile);
            if (pixels == 0) continue;
            auto work = std::make_unique<TileWork>();
            work->tile = tile;
            work->pass = pass_;
            work->clock = StageClock(settings_.time_stages);
            work->pixels = pixels;
            return work;
        }
    }

    /// One worker's share of a step. A tile that it has to put down stays in its hand.
    void work(std::uint32_t worker, Deadline deadline) {
        const FpEnvironment environment;
        StopCheck stop(cancelled_, deadline);
        std::unique_ptr<TileWork>& tile = in_hand_[worker];
        // The first ask is granted to the tile, not spent here, so that each step gets somewhere.
        do {
            if (tile == nullptr) tile = take_tile();
            if (tile == nullptr) return;
            tile->clock.go_on();
            renderer_->render_tile(*tile, film_, stop);
            tile->clock.pause();
            if (!tile->done()) return;
            totals_[worker].add(*tile);
            tile.reset();
        } while (!stop.now());
    }

    /// Of tiles that are done.
    [[nodiscard]] Totals finished() const {
        Totals sum = before_;
        for (const Totals& worker : totals_) sum.add(worker);
        return sum;
    }

    [[nodiscard]] Totals total() const {
        Totals sum = finished();
        for (const auto& tile : in_hand_) {
            if (tile != nullptr) sum.add(*tile);
        }
        return sum;
    }

    [[nodiscard]] Progress progress() const {
        const Totals sum = total();
        Progress result;
        result.done = complete_ || cancelled();
        // What is expected is no more than that, until the last sample is there.
        const auto expected = static_cast<double>(plan_->expected_samples());
        const auto taken = static_cast<double>(sum.samples);
        constexpr double kNearlyAll = 0.999;
        result.fraction = complete_ ? 1 : taken >= expected ? kNearlyAll : taken / expected;
        result.rays = sum.counters.rays();
        result.seconds = seconds_;
        result.forecast = plan_->forecast();
        return result;
    }

    const ir::Scene* scene_;
    Settings settings_;
    Scheduler* scheduler_;
    Film film_;
    std::vector<Tile> tiles_;
    std::unique_ptr<PassPlan> plan_;
    SamplePass pass_;
    std::vector<std::unique_ptr<TileWork>> in_hand_;  ///< by worker
    std::vector<Totals> totals_;                      ///< by worker
    std::unique_ptr<TileRenderer> renderer_;
    std::atomic<std::size_t> next_tile_ = 0;
    bool pass_over_ = false;  ///< all tiles of it are done
    // Of what is worked out between passes.
    std::atomic<std::uint32_t> next_part_ = 0;
    std::uint32_t parts_ = 0;
    std::atomic<bool> cancelled_ = false;
    std::uint64_t bytes_ = 0;
    double prepare_seconds_ = 0;
    std::optional<Clock::time_point> step_start_;  ///< of a step that goes on with passes
    double steps_seconds_ = 0;
    double render_processor_seconds_ = 0;
    double seconds_ = 0;
    // Of a job that goes on with what another has done.
    Totals before_;
    double render_seconds_before_ = 0;
    PixelMask left_;                       ///< of its first pass
    std::vector<std::uint8_t> last_plan_;  ///< the plan's bytes at the pass before this one
    bool begun_ = false;
    bool complete_ = false;
    bool prepared_ = false;
    std::unique_ptr<Background> preparation_;  ///< last: its end is waited for before all else goes
};

}  // namespace

std::unique_ptr<RenderJob> start_render(const ir::Scene& scene, const Settings& settings,
                                        Scheduler& scheduler) {
    return std::make_unique<Job>(scene, settings, scheduler);
}

Resumed resume_render(const ir::Scene& scene, const Settings& settings, Scheduler& scheduler,
                      std::string_view state) {
    auto job = std::make_unique<Job>(scene, settings, scheduler);
    std::string problem = job->restore(state);
    if (!problem.empty()) job.reset();
    return {std::move(job), std::move(problem)};
}

}  // namespace cobble::renderer
