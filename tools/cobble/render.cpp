// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/cost/budget.hpp"
#include "renderer/job/render_job.hpp"
#include "tools/cobble/accuracy_options.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/checkpointing.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/interrupt.hpp"
#include "tools/cobble/progress.hpp"
#include "tools/cobble/usage.hpp"
#include "tools/cobble/view_options.hpp"
#include "tools/driver/outputs.hpp"
#include "tools/driver/pictures.hpp"
#include "tools/driver/render_targets.hpp"
#include "tools/driver/report/accuracy_text.hpp"
#include "tools/driver/report/preparation_notes.hpp"
#include "tools/driver/report/render_stats.hpp"
#include "tools/driver/target_files.hpp"
#include "tools/driver/text.hpp"
#include "tools/driver/write_file.hpp"

namespace cobble {
namespace {

// Short enough that an interrupt, which a step does not have to wait for, is felt at once, and
// long enough that stopping and starting the workers costs nothing beside it.
constexpr std::chrono::milliseconds kStep{50};

// The part of its samples from which an interrupted picture shows more than the old file that it
// would replace.
constexpr double kWorthKeeping = 0.01;

struct Options {
    ViewOptions view;
    AccuracyOptions accuracy;
    driver::TargetPaths pictures;
    std::string stats;
    std::string filter = "box";
    std::optional<Shard> shard;
    CheckpointOptions checkpoint;
    std::uint32_t threads = 0;
    bool reference = false;
    bool quiet = false;
};

class Render {
  public:
    explicit Render(const Options& options)
        : options_(options),
          targets_(driver::targets_of(options.pictures)),
          checkpointing_(options.checkpoint) {}

    int run() {
        if (targets_.empty()) {
            return usage_error("render", "there is no picture to write: say -o FILE");
        }
        if (std::string problem = check_options(); !problem.empty()) {
            return usage_error("render", problem);
        }
        if (std::string problem = check_outputs(); !problem.empty()) {
            driver::complain(problem);
            return kFailure;
        }
        view_ = make_view("render", options_.view, options_.quiet);
        if (view_.status != 0) return view_.status;
        // Only now is it known which meshes and pictures the scene is made of.
        if (std::string problem = driver::check_distinct(output_paths(), view_.loaded.files);
            !problem.empty()) {
            driver::complain(problem);
            return kFailure;
        }
        complete_settings();
        return render();
    }

  private:
    [[nodiscard]] std::vector<std::string> output_paths() const {
        std::vector<std::string> paths;
        for (const driver::RenderTarget& target : targets_) paths.push_back(target.path);
        if (!options_.stats.empty()) paths.push_back(options_.stats);
        if (!options_.checkpoint.path.empty()) paths.push_back(options_.checkpoint.path);
        return paths;
    }

    // What no scene can make right.
    [[nodiscard]] std::string check_options() const {
        const ViewOptions& view = options_.view;
        const std::optional<Shard>& shard = options_.shard;
        const std::optional<renderer::Crop>& crop = view.crop;
        if (std::string problem = check_accuracy(options_.accuracy, !view.compat.empty());
            !problem.empty()) {
            return problem;
        }
        // Which pixels are done depends on their neighbours.
        if (shard && options_.accuracy.error > 0 && !options_.accuracy.guarantee) {
            return "'--shard' does not go with '--error': a pixel's samples depend on those of its "
                   "neighbours, which are in other parts";
        }
        if (shard && shard->count > 1 && options_.accuracy.budget > 0) {
            return "'--shard' does not go with '--budget': each part would take samples of its own";
        }
        if (options_.stats == "-") {
            return "'--stats' wants a file, and does not write to standard output (./- is a file "
                   "of that name)";
        }
        if (options_.checkpoint.path.empty()) {
            for (const char* option : {"--resume", "--checkpoint-interval"}) {
                if (std::find(view.given.begin(), view.given.end(), option) == view.given.end()) {
                    continue;
                }
                return fmt::format("'{}' means nothing without '--checkpoint FILE'", option);
            }
        }
        if (options_.checkpoint.resume && options_.accuracy.budget > 0) {
            return "'--resume' does not go with '--budget', which would choose other samples: give "
                   "those that the first run printed";
        }
        if (crop && (crop->x0 >= view.size.width || crop->y0 >= view.size.height)) {
            return "'--crop' lies outside the picture of " + to_text(view.size);
        }
        // Each part would find a range of its own.
        if (shard && shard->count > 1 && !view.depth_range && !options_.pictures.depth.empty() &&
            driver::keeps_bytes(options_.pictures.depth)) {
            return "'--shard' needs a '--depth-range' that all parts share where distances are "
                   "grey";
        }
        return {};
    }

    // Before anything is read: whether what comes out has a place to go.
    [[nodiscard]] std::string check_outputs() const {
        const std::vector<std::string> paths = output_paths();
        std::vector<std::string> inputs;
        if (options_.view.scene != "-") inputs.push_back(options_.view.scene);
        if (std::string problem = driver::check_distinct(paths, inputs); !problem.empty()) {
            return problem;
        }
        renderer::Settings settings;
        settings.width = options_.view.size.width;
        settings.height = options_.view.size.height;
        settings.crop = options_.view.crop;
        const renderer::Crop window = renderer::window_of(settings);
        if (std::string problem = driver::check_targets(targets_, window); !problem.empty()) {
            return problem;
        }
        if (std::string problem =
                driver::check_memory(targets_.size(), window, bytes_of_pixel(options_.accuracy));
            !problem.empty()) {
            return problem;
        }
        if (!options_.stats.empty()) {
            std::string problem = driver::check_writable(options_.stats, 0);
            if (!problem.empty()) return problem;
        }
        return checkpointing_.check();
    }

    void complete_settings() {
        renderer::Settings& settings = view_.settings;
        if (options_.reference) settings.acceleration = renderer::Acceleration::kBvh;
        if (options_.filter == "tent") settings.filter = renderer::PixelFilter::kTent;
        if (options_.filter == "gaussian") settings.filter = renderer::PixelFilter::kGaussian;
        set_accuracy(options_.accuracy, options_.view.transfer == "srgb", settings);
        if (options_.shard) {
            settings.shard_index = options_.shard->index - 1;
            settings.shard_count = options_.shard->count;
        }
        settings.time_stages = !options_.stats.empty();
        settings.want_depth = !options_.pictures.depth.empty();
        settings.want_normals = !options_.pictures.normals.empty();
        settings.want_albedo = !options_.pictures.albedo.empty();
        settings.want_sample_count = !options_.pictures.sample_count.empty();
        if (options_.view.depth_range) {
            settings.compat.depth_min = options_.view.depth_range->min;
            settings.compat.depth_max = options_.view.depth_range->max;
        }
    }

    int render() {
        const bool terminal = driver::is_terminal(STDERR_FILENO);
        const auto kind = options_.quiet ? ProgressBar::Kind::kSilent
                          : terminal     ? ProgressBar::Kind::kTerminal
                                         : ProgressBar::Kind::kLines;
        ProgressBar bar(kind, driver::terminal_width(STDERR_FILENO, 80));
        const auto scheduler = renderer::make_thread_scheduler(options_.threads);
        if (options_.accuracy.budget > 0 && !choose_samples(*scheduler)) return leave_as_it_was();
        if (settings_of_goal() != nullptr) announce(*settings_of_goal());
        const auto started =
            checkpointing_.start(view_.loaded.lowered.scene, view_.settings, *scheduler);
        const std::unique_ptr<renderer::RenderJob>& job = started.job;
        if (job == nullptr) {
            driver::complain(started.problem);
            return kFailure;
        }
        if (started.anew && !options_.quiet) {
            driver::complain(checkpointing_.path() +
                             " is not there: the render starts from its beginning");
        }
        const InterruptGuard guard(job.get());
        renderer::Progress progress;
        bool said_resumed = false;
        while (!progress.done) {
            progress = job->step(std::chrono::steady_clock::now() + kStep);
            if (started.resumed && !said_resumed) {
                said_resumed = true;
                say(fmt::format("going on from {} at {:.0f} %\n", checkpointing_.path(),
                                std::floor(progress.fraction * 100)));
            }
            if (progress.forecast && !said_forecast_) {
                said_forecast_ = true;
                bar.clear();
                say(driver::forecast_text(*progress.forecast, view_.settings.goal->error));
            }
            bar.show(progress.fraction, progress.rays, progress.seconds);
            if (!progress.done) checkpointing_.look_in(*job);
        }
        bar.clear();
        return finish(*job, progress);
    }

    int finish(const renderer::RenderJob& job, const renderer::Progress& progress) {
        const renderer::Picture picture = job.picture();
        if (!picture.complete) {
            if (progress.fraction > 0 && checkpointing_.save(job)) {
                const std::string instead =
                    options_.accuracy.budget > 0
                        ? fmt::format(" with '--samples {} --scrambles {}' in place of '--budget'",
                                      view_.settings.samples, view_.settings.scrambles)
                        : std::string();
                driver::complain(fmt::format(
                    "interrupted at {:.0f} %: the checkpoint is in {}, and '--resume' "
                    "goes on from it{}",
                    std::floor(progress.fraction * 100), checkpointing_.path(), instead));
                return kInterrupted;
            }
            if (progress.fraction < kWorthKeeping) return leave_as_it_was();
        }
        const int status = write(picture, job.stats(), progress);
        if (status != kDone) {
            if (picture.complete && checkpointing_.save(job)) {
                driver::complain(fmt::format("the render is done: '--resume' writes it from {}",
                                             checkpointing_.path()));
            }
            return status;
        }
        if (!picture.complete) {
            driver::complain(
                fmt::format("interrupted at {:.0f} %: the picture as far as it came is in {}",
                            std::floor(progress.fraction * 100), targets_.front().path));
            return kInterrupted;
        }
        checkpointing_.remove();
        if (!options_.quiet) {
            say_what_was_done(progress, job.stats(), picture.*targets_.front().plane);
        }
        // With --keep-going there is a picture, and still something to mend.
        return driver::has_errors(view_.loaded.diagnostics) ? kFindings : kDone;
    }

    [[nodiscard]] int leave_as_it_was() const {
        const std::string& path = targets_.front().path;
        const bool exists = access(path.c_str(), F_OK) == 0;
        driver::complain("interrupted at 0 %: nothing was written" +
                         (exists ? ", and " + path + " is as it was" : ""));
        return kInterrupted;
    }

    void say(const std::string& text) const {
        if (!options_.quiet) driver::write_error(text);
    }

    [[nodiscard]] const renderer::ErrorGoal* settings_of_goal() const {
        return view_.settings.goal ? &*view_.settings.goal : nullptr;
    }

    void announce(const renderer::ErrorGoal& goal) const {
        if (goal.method == renderer::ErrorGoal::Method::kGuarantee) {
            say(driver::guarantee_text(goal));
        }
    }

    // By a trial; false if it was interrupted.
    bool choose_samples(renderer::Scheduler& scheduler) {
        const InterruptGuard guard;
        // Of a trial of some seconds people shall know.
        constexpr double kLong = 20;
        if (options_.accuracy.budget > kLong) {
            say(fmt::format("budget {:g} s: trying how long samples take\n",
                            options_.accuracy.budget));
        }
        const auto choice = renderer::choose_for_budget(
            view_.loaded.lowered.scene, view_.settings, options_.accuracy.budget, scheduler,
            [] { return InterruptGuard::interrupted(); });
        if (!choice) return false;
        view_.settings.samples = choice->samples;
        say(driver::budget_text(*choice, view_.settings.scrambles, options_.accuracy.budget));
        return true;
    }

    void say_what_was_done(const renderer::Progress& progress, const renderer::Stats& stats,
                           const renderer::Plane32& plane) const {
        const double rate = static_cast<double>(progress.rays) / std::max(progress.seconds, 1e-9);
        // A published program takes as many samples as its flags say.
        const std::uint32_t samples = view_.settings.samples;
        const std::string sampling =
            view_.compat != ir::Compat::kNone ? "as " + options_.view.compat
            : stats.achieved && settings_of_goal() != nullptr
                ? fmt::format("{:.0f} samples a pixel", stats.achieved->samples)
                : fmt::format("{} sample{} a pixel", samples, samples == 1 ? "" : "s");
        driver::write_error(fmt::format("{}: {}x{}, {}, {}rays in {:.2f} s ({}rays/s)\n",
                                        driver::printable(targets_.front().path), plane.width,
                                        plane.height, sampling,
                                        short_number(static_cast<double>(progress.rays)),
                                        progress.seconds, short_number(rate)));
        if (!stats.achieved) return;
        driver::write_error(driver::achieved_text(*stats.achieved, settings_of_goal()));
    }

    int write(const renderer::Picture& picture, const renderer::Stats& stats,
              const renderer::Progress& progress) {
        const auto begin = std::chrono::steady_clock::now();
        if (stats.bad_sample_count > 0) {
            driver::complain(driver::bad_sample_text(stats, view_.loaded.session->sources));
        }
        if (!options_.quiet) {
            driver::Positions positions(view_.loaded.session->sources);
            const ir::Scene& scene = view_.loaded.lowered.scene;
            const auto notes =
                driver::without_checked(stats.notes, scene, view_.loaded.diagnostics);
            driver::write_error(driver::notes_to_text(notes, scene, positions,
                                                      driver::prepared_in(scene, view_.settings)));
        }
        // Last: what failed has the last word.
        int status = kDone;
        for (const driver::RenderTarget& target : targets_) {
            const std::string problem = driver::write_target(target, picture, style(stats));
            if (problem.empty()) continue;
            driver::complain(problem);
            status = kFailure;
        }
        if (options_.stats.empty()) return status;
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
        const std::string text = driver::stats_to_json(
            {view_.loaded, view_.settings, stats, progress, picture.complete, seconds.count()});
        if (std::string problem = driver::write_file(options_.stats, text); !problem.empty()) {
            driver::complain(problem);
            status = kFailure;
        }
        return status;
    }

    [[nodiscard]] driver::TargetStyle style(const renderer::Stats& stats) const {
        driver::TargetStyle style{view_.loaded.lowered.scene, view_.settings, {}, {}, false};
        if (const renderer::ErrorGoal* const goal = settings_of_goal()) {
            // All parts of a picture have one white.
            style.most_samples =
                stats.achieved && !options_.shard ? stats.achieved->most : goal->most_samples;
        }
        if (const auto& range = options_.view.depth_range) {
            style.depth_range = std::pair(range->min, range->max);
        }
        style.transfer = options_.view.transfer;
        style.is_shard = options_.shard.has_value();
        return style;
    }

    const Options& options_;
    std::vector<driver::RenderTarget> targets_;
    Checkpointing checkpointing_;
    View view_;
    bool said_forecast_ = false;
};

void add_outputs(CLI::App& sub, Options& options) {
    const std::string group = "Pictures (.png .pfm .hdr .exr .bmp .tga)";
    const auto add = [&sub, &group](const std::string& name, std::string& path,
                                    const std::string& description) {
        sub.add_option(name, path, description)->type_name("FILE")->group(group);
    };
    add("-o,--output", options.pictures.color, "The picture");
    add("--depth", options.pictures.depth, "Distances from the camera; grey in 8-bit formats");
    add("--normals", options.pictures.normals, "Shading normals");
    add("--albedo", options.pictures.albedo, "Colours of the surfaces before lighting");
    add("--sample-count", options.pictures.sample_count,
        "Samples that each pixel took; white is the most in 8-bit formats");
    add_parsed(sub, "--depth-range", "MIN,MAX", "MIN,MAX with MIN below MAX, such as 2,10",
               parse_depth_range, options.view.depth_range,
               "Distances that are white and black in 8-bit formats (default: those there are)")
        ->group(group);
}

}  // namespace

void add_render(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("render", "Render a scene to a picture");
    add_view_options(*sub, options->view);
    add_outputs(*sub, *options);
    add_accuracy_options(*sub, options->accuracy);
    add_compat_options(*sub, options->view);
    add_parsed(*sub, "--crop", "X0,Y0,X1,Y1",
               "X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1, such as 0,0,320,240", parse_crop,
               options->view.crop, "Render these pixels only, Y from the top");
    add_choice(*sub, "--filter", options->filter, {"box", "tent", "gaussian"},
               "Pixel filter: box, tent or gaussian");
    require_whole(sub->add_option("--threads", options->threads, "Workers; 0 is one a processor"),
                  0, 1024)
        ->type_name("N")
        ->capture_default_str();
    sub->add_flag("--reference", options->reference,
                  "One ray at a time on a plain tree: slow, and the same picture");
    add_parsed(*sub, "--shard", "I/N", "I/N with 1 <= I <= N, such as 1/4", parse_shard,
               options->shard, "Render part I of N, from 1; `cobble merge` joins the parts");
    add_checkpoint_options(*sub, options->checkpoint);
    sub->add_option("--stats", options->stats,
                    "Write times, rays by kind and memory to this file as JSON")
        ->type_name("FILE");
    sub->add_flag("--quiet", options->quiet, "No progress, no warnings");
    sub->footer(
        "The original programs' spellings work too: -input F, -output F, -size W H, -depth MIN MAX "
        "F,\n-normals F, -bounces N, -shadows, -jitter, -filter, -casting, -blurry FOCUS, "
        "-pixelated.");
    sub->callback([options, sub, &context] {
        for (const CLI::Option* option : sub->get_options()) {
            if (option->count() > 0) options->view.given.push_back(option->get_name());
        }
        const auto given = [sub](const char* name) { return sub->count(name) > 0; };
        options->accuracy.samples_given = given("--samples");
        options->accuracy.scrambles_given = given("--scrambles");
        options->accuracy.most_given = given("--max-samples");
        context.run = [options] { return Render(*options).run(); };
    });
}

}  // namespace cobble
