// SPDX-License-Identifier: MIT
#include "renderer/stability/stability.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <utility>

#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/progress.hpp"
#include "tools/cobble/usage.hpp"
#include "tools/cobble/view_options.hpp"
#include "tools/driver/report/figures.hpp"
#include "tools/driver/report/stability_report.hpp"
#include "tools/driver/text.hpp"
#include "tools/driver/walk.hpp"

namespace cobble {
namespace {

// An hour or two of them.
constexpr std::uint64_t kMostRays = 1000000000;
// More than the rays of the default take in any scene that has been tried.
constexpr double kBudgetSeconds = 60;

struct Options {
    ViewOptions view;
    std::string folder;
    std::string format = "human";
    std::uint64_t rays = renderer::StabilityOptions{}.rays;
    double budget = kBudgetSeconds;
    bool json = false;
};

class StabilityCommand {
  public:
    StabilityCommand(const Options& options, Context& context)
        : options_(options),
          context_(context),
          json_(options.json || options.format == "json"),
          bar_(driver::is_terminal(STDERR_FILENO) ? ProgressBar::Kind::kTerminal
                                                  : ProgressBar::Kind::kSilent,
               driver::terminal_width(STDERR_FILENO, 80)) {}

    int run() {
        if (options_.folder.empty() == options_.view.scene.empty()) {
            return usage_error("stability", options_.folder.empty()
                                                ? "SCENE or --all FOLDER is required"
                                                : "SCENE does not go with --all");
        }
        return options_.folder.empty() ? one() : all();
    }

  private:
    int one() {
        const View view = make_view("stability", options_.view, true);
        if (view.status != 0) return view.status;
        const renderer::Stability stability = measure(view.loaded.lowered.scene);
        // What its objects are said to stand in.
        const source::SourceMap& sources = view.loaded.session->sources;
        const driver::StabilityReport report =
            report_of(stability, view.loaded, sources.path(view.loaded.session->scene));
        context_.out.write(json_ ? driver::pretty(driver::stability_to_json(report))
                                 : driver::stability_to_text(report, style_));
        return stability.clean() && !driver::has_errors(view.loaded.diagnostics) ? kDone
                                                                                 : kFindings;
    }

    int all() {
        const driver::SceneFiles files = driver::find_scenes({options_.folder});
        for (const std::string& problem : files.problems) driver::complain(problem);
        failed_ = !files.problems.empty();
        driver::Json scenes = driver::Json::array();
        scenes_ = files.paths.size();
        for (const std::string& path : files.paths) {
            driver::Json entry = measure_one_of(path);
            if (json_) scenes.push_back(std::move(entry));
            ++reached_;
            // Whoever waits or interrupts sees what is done.
            if (!json_) context_.out.flush();
        }
        if (json_) {
            context_.out.write(driver::pretty({{"cobble_stability", 1},
                                               {"scenes", std::move(scenes)},
                                               {"summary",
                                                {{"scenes", scenes_},
                                                 {"sound", sound_},
                                                 {"with_faults", faulty_},
                                                 {"not_measured", not_measured_}}}}));
        } else {
            context_.out.flush();
            driver::write_error(fmt::format("{}: {} sound, {} with faults, {} not measured\n",
                                            driver::counted(scenes_, "scene"), sound_, faulty_,
                                            not_measured_));
        }
        if (failed_) return kFailure;
        return faulty_ + not_measured_ > 0 ? kFindings : kDone;
    }

    driver::Json measure_one_of(const std::string& path) {
        const driver::LoadedScene loaded = driver::load_scene(path, {}, {});
        const std::string problem = why_not(loaded, path);
        if (!problem.empty()) {
            ++not_measured_;
            if (!json_) {
                context_.out.write(fmt::format("{}: not measured: {}\n", driver::printable(path),
                                               driver::printable(problem)));
            }
            return {{"path", path}, {"problem", problem}};
        }
        const renderer::Stability stability = measure(loaded.lowered.scene);
        const driver::StabilityReport report = report_of(stability, loaded, path);
        const bool clean = stability.clean();
        ++(clean ? sound_ : faulty_);
        if (json_) return driver::stability_to_json(report);
        context_.out.write(driver::stability_line(report));
        if (!clean) context_.out.write(driver::stability_to_text(report, style_));
        return {};
    }

    /// "" for a scene that can be measured.
    std::string why_not(const driver::LoadedScene& loaded, const std::string& path) {
        if (loaded.session == nullptr) {
            failed_ = true;
            return loaded.problem;
        }
        std::uint64_t errors = 0;
        for (const source::Diagnostic& diagnostic : loaded.diagnostics) {
            errors += diagnostic.severity == source::Severity::kError ? 1 : 0;
        }
        if (errors > 0 && !options_.view.keep_going) {
            return fmt::format("it has {} (cobble lint {})", driver::counted(errors, "error"),
                               path);
        }
        return loaded.lowered.renderable ? "" : "it has nothing to render";
    }

    renderer::Stability measure(const ir::Scene& scene) {
        using Clock = std::chrono::steady_clock;
        const auto begin = Clock::now();
        renderer::StabilityOptions how;
        how.rays = options_.rays;
        how.width = options_.view.size.width;
        how.height = options_.view.size.height;
        how.go_on = [this, begin](double fraction, std::uint64_t rays) {
            const std::chrono::duration<double> seconds = Clock::now() - begin;
            if (scenes_ == 0) {
                bar_.show(fraction, rays, seconds.count());
            } else {
                const std::chrono::duration<double> sum = Clock::now() - start_;
                bar_.show((static_cast<double>(reached_) + fraction) / static_cast<double>(scenes_),
                          rays_ + rays, sum.count());
            }
            return seconds.count() < options_.budget;
        };
        renderer::Stability stability = renderer::measure_stability(scene, how);
        rays_ += stability.rays + stability.picture_rays + stability.departures;
        bar_.clear();
        return stability;
    }

    driver::StabilityReport report_of(const renderer::Stability& stability,
                                      const driver::LoadedScene& loaded,
                                      std::string_view path) const {
        const Size size = options_.view.size;
        return {stability, loaded.lowered.scene, loaded.session->sources,
                path,      size.width,           size.height};
    }

    const Options& options_;
    Context& context_;
    bool json_;
    driver::ReportStyle style_{driver::wants_color(STDOUT_FILENO),
                               driver::terminal_width(STDOUT_FILENO, 100)};
    ProgressBar bar_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::uint64_t rays_ = 0;
    // Of --all.
    std::size_t scenes_ = 0, reached_ = 0, sound_ = 0, faulty_ = 0, not_measured_ = 0;
    bool failed_ = false;
};

}  // namespace

void add_stability(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("stability", "Say how a scene stands up to float");
    sub->add_option("SCENE", options->view.scene, "The scene file, or - for standard input");
    sub->add_option("--all", options->folder,
                    "Every scene under a folder, a line for each and all about those with faults")
        ->type_name("FOLDER");
    add_size_option(*sub, options->view);
    require_whole(sub->add_option("--rays", options->rays,
                                  "Rays at objects; no object gets more than a hundredth"),
                  1, kMostRays)
        ->type_name("N")
        ->capture_default_str();
    require_above(sub->add_option("--budget", options->budget,
                                  "Stop casting after so many seconds a scene, and say so"),
                  0)
        ->type_name("SECONDS")
        ->capture_default_str();
    add_choice(*sub, "--format", options->format, {"human", "json"}, "How it is printed");
    sub->add_flag("--json", options->json, "The same as --format json");
    sub->add_flag("--keep-going", options->view.keep_going,
                  "Measure what is sound of a scene with errors");
    add_stdin_path(*sub, options->view.stdin_path);
    sub->footer(
        "Rays from the camera at vertices, edges, outlines and faces, and rays that leave what "
        "they hit,\nare cast in float, by the kernels that render, and in double.\n"
        "A crack: float sees through. Changed: it sees what is not there. A self-hit: a ray that "
        "leaves\na surface meets it again. Each is counted only beyond what rounding explains. "
        "Lost: "
        "rays in\ndouble that see an object which float sees nothing of. None is expected.\n"
        "Rays are not followed through glass or off mirrors: objects that none meets are counted.\n"
        "ulps/pixel: the "
        "least number of float's steps\nacross a pixel of the object: below 4 neighbours may look "
        "alike, below 1 float is too coarse.\nExit status 1 if there is a crack, a changed hit, a "
        "self-hit, an object lost or one that float\nis too coarse for, or a scene that has "
        "errors.");
    sub->callback([options, &context] {
        context.run = [options, &context] { return StabilityCommand(*options, context).run(); };
    });
}

}  // namespace cobble
