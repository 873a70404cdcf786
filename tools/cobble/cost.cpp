// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "renderer/cost/study.hpp"
#include "renderer/metrics/compare.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/interrupt.hpp"
#include "tools/cobble/usage.hpp"
#include "tools/cobble/view_options.hpp"
#include "tools/driver/outputs.hpp"
#include "tools/driver/report/cost_report.hpp"
#include "tools/driver/text.hpp"
#include "tools/driver/write_file.hpp"

namespace cobble {
namespace {

struct Options {
    ViewOptions view;
    std::string svg, shares, html;
    double budget = 60;
    double ppd = renderer::kDefaultPixelsPerDegree;
    std::uint32_t threads = 0;
    bool samples_given = false;
    bool json = false;
    bool quiet = false;
};

std::vector<std::string> outputs_of(const Options& options) {
    std::vector<std::string> paths;
    for (const std::string* path : {&options.svg, &options.shares, &options.html}) {
        if (!path->empty()) paths.push_back(*path);
    }
    return paths;
}

// Before a minute is spent: whether what comes out has a place to go.
std::string check_outputs(const Options& options) {
    const std::vector<std::string> paths = outputs_of(options);
    std::vector<std::string> inputs;
    if (options.view.scene != "-") inputs.push_back(options.view.scene);
    std::string problem = driver::check_distinct(paths, inputs);
    for (const std::string& path : paths) {
        if (problem.empty()) problem = driver::check_writable(path, 0);
    }
    return problem;
}

std::string write_outputs(const Options& options, const renderer::CostReport& report) {
    std::string problem;
    const auto write = [&problem](const std::string& path, auto make) {
        if (!problem.empty() || path.empty()) return;
        problem = driver::write_file(path, make());
    };
    write(options.svg, [&] { return driver::cost_to_svg(report); });
    write(options.shares, [&] { return driver::cost_shares_to_svg(report); });
    write(options.html, [&] { return driver::cost_to_html(report); });
    return problem;
}

int run(const Options& options, Context& context) {
    if (options.samples_given) {
        return usage_error("cost",
                           "a study tries numbers of samples by itself: leave '--samples' out");
    }
    for (const std::string& path : outputs_of(options)) {
        if (path != "-") continue;
        return usage_error("cost",
                           "charts and pages are written to files (./- is a file of that name)");
    }
    if (std::string problem = check_outputs(options); !problem.empty()) {
        driver::complain(problem);
        return kFailure;
    }
    const View view = make_view("cost", options.view, options.quiet);
    if (view.status != 0) return view.status;
    renderer::StudyOptions study;
    study.seconds = options.budget;
    study.keep_pictures = !options.html.empty();
    study.pixels_per_degree = options.ppd;
    study.light = options.view.transfer == "srgb";
    const auto scheduler = renderer::make_thread_scheduler(options.threads);
    const InterruptGuard guard;
    auto report = renderer::study_cost(
        view.loaded.lowered.scene, view.settings, *scheduler, study,
        [] { return InterruptGuard::interrupted(); },
        [&](std::string_view part, double fraction) {
            if (options.quiet) return;
            driver::write_error(fmt::format("{:3.0f} %  {} ...\n", 100 * fraction, part));
        });
    if (!report) {
        driver::complain("interrupted: a study that is not finished tells nothing");
        return kInterrupted;
    }
    report->scene = options.view.scene == "-" ? "<stdin>" : options.view.scene;
    if (options.json) {
        context.out.write(driver::pretty(driver::cost_to_json(*report)));
    } else {
        const driver::ReportStyle style{driver::wants_color(STDOUT_FILENO),
                                        driver::terminal_width(STDOUT_FILENO, 100)};
        context.out.write(driver::cost_to_text(*report, style));
    }
    if (const std::string problem = write_outputs(options, *report); !problem.empty()) {
        driver::complain(problem);
        return kFailure;
    }
    return driver::has_errors(view.loaded.diagnostics) ? kFindings : kDone;
}

}  // namespace

void add_cost(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("cost", "Show what accuracy costs in time on a scene");
    add_view_options(*sub, options->view);
    sub->add_flag("--json", options->json, "JSON instead of tables");
    sub->add_option("--svg", options->svg, "Write a chart of error over time to this file")
        ->type_name("FILE");
    sub->add_option("--svg-shares", options->shares,
                    "Write a chart of each effect's share of time and noise to this file")
        ->type_name("FILE");
    sub->add_option("--html", options->html,
                    "Write a page with charts, tables and pictures to this file")
        ->type_name("FILE");
    require_above(sub->add_option("--budget", options->budget, "Time for the study itself, about"),
                  0)
        ->type_name("SECONDS")
        ->capture_default_str();
    require_number(
        sub->add_option("--ppd", options->ppd, "Pixels per degree of the viewer's sight, for FLIP"),
        1, 4000)
        ->type_name("P")
        ->capture_default_str();
    require_whole(sub->add_option("--threads", options->threads, "Workers; 0 is one a processor"),
                  0, 1024)
        ->type_name("N")
        ->capture_default_str();
    sub->add_flag("--quiet", options->quiet, "No progress, no warnings");
    sub->callback([options, sub, &context] {
        options->samples_given = sub->count("--samples") > 0;
        context.run = [options, &context] { return run(*options, context); };
    });
}

}  // namespace cobble
