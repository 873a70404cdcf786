// SPDX-License-Identifier: MIT
#include <unistd.h>
#include <CLI/CLI.hpp>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/interrupt.hpp"
#include "tools/driver/disk_file_source.hpp"
#include "tools/driver/fixes.hpp"
#include "tools/driver/report/reporter.hpp"
#include "tools/driver/session.hpp"
#include "tools/driver/unified_diff.hpp"
#include "tools/driver/walk.hpp"
#include "tools/driver/write_file.hpp"

namespace cobble {
namespace {

struct Options {
    std::vector<std::string> paths;
    std::string format = "human";
    std::string stdin_path;
    bool fix = false;
    bool unsafe_fixes = false;
    bool diff = false;
    std::uint64_t max_errors = std::numeric_limits<std::uint64_t>::max();
    std::vector<std::string> denied, allowed;
};

class Lint {
  public:
    Lint(const Options& options, Context& context)
        : options_(options),
          context_(context),
          fixing_(options.fix || options.unsafe_fixes || options.diff) {
        rules_.denied.insert(options.denied.begin(), options.denied.end());
        rules_.allowed.insert(options.allowed.begin(), options.allowed.end());
    }

    int run() {
        for (const auto* codes : {&options_.denied, &options_.allowed}) {
            for (const std::string& code : *codes) {
                if (source::find_code(code) != nullptr) continue;
                driver::complain("there is no diagnostic '" + code + "'" + similar_code(code));
                return kFailure;
            }
        }
        if (!stdin_path_is_used("lint", options_.stdin_path, options_.paths)) return kFailure;
        if (options_.diff && options_.format != "human") {
            driver::complain(
                "--diff prints a diff instead of findings: it does not go with "
                "--format " +
                options_.format);
            return kFailure;
        }
        const driver::SceneFiles files = driver::find_scenes(options_.paths);
        for (const std::string& problem : files.problems) fail(problem);

        // A fixed standard input takes standard output for itself.
        const bool to_error = fixing_ && !options_.diff && contains_dash(files.paths);
        const int descriptor = to_error ? STDERR_FILENO : STDOUT_FILENO;
        const auto format = driver::report_format(options_.format);
        const driver::ReportStyle style{driver::wants_color(descriptor),
                                        driver::terminal_width(descriptor, 100)};
        reporter_ = driver::make_reporter(*format, style, [this, to_error](std::string_view text) {
            if (options_.diff) return;
            if (to_error) {
                driver::write_error(text);
            } else {
                context_.out.write(text);
            }
        });
        for (const std::string& path : files.paths) {
            lint(path);
            if (InterruptGuard::interrupted()) {
                driver::complain("interrupted; the files not yet reached are as they were");
                return kInterrupted;
            }
        }
        reporter_->finish(summary_);
        if (*format == driver::ReportFormat::kHuman) {
            context_.out.flush();
            driver::write_error(driver::to_text(summary_) + hidden_text() + "\n" + hint());
        }
        if (failed_) return kFailure;
        return summary_.errors > 0 ? kFindings : kDone;
    }

  private:
    static bool contains_dash(const std::vector<std::string>& paths) {
        return std::find(paths.begin(), paths.end(), "-") != paths.end();
    }

    void fail(std::string_view problem) {
        context_.out.flush();
        driver::complain(problem);
        failed_ = true;
    }

    void lint(const std::string& argument) {
        const bool standard_input = argument == "-";
        driver::ReadText file =
            standard_input ? driver::read_standard_input() : driver::read_text(argument);
        if (!file.problem.empty()) return fail(file.problem);
        std::string path = argument;
        if (standard_input) path = options_.stdin_path.empty() ? "<stdin>" : options_.stdin_path;

        if (fixing_) file.text = fix(path, std::move(file.text), standard_input);
        driver::Session session(path, std::move(file.text));
        driver::FileReport report{session.scene, &session.sources,
                                  driver::lint(session, disk_, rules_)};
        ++summary_.files;
        count(report);
        reporter_->file(report);
    }

    // Gives the text to report on: the fixed one, or with --diff the one that is on the disk.
    std::string fix(const std::string& path, std::string text, bool standard_input) {
        driver::Fixed fixed =
            driver::fix_until_stable(path, text, disk_, rules_, options_.unsafe_fixes);
        if (fixed.too_many) {
            context_.out.flush();
            driver::complain(
                path +
                (fixed.applied == 0 ? ": fixes were not applied" : ": not all fixes were applied") +
                ": too many findings");
        }
        if (options_.diff) {
            const driver::DiffStyle style{driver::wants_color(STDOUT_FILENO)};
            context_.out.write(driver::unified_diff(text, fixed.text, path, path, style));
            return text;
        }
        if (standard_input) {
            context_.out.write(fixed.text);
        } else if (fixed.text != text) {
            // An interrupt waits until the file is whole; before, there is nothing to save.
            const InterruptGuard guard;
            if (const std::string problem = driver::write_file(path, fixed.text);
                !problem.empty()) {
                fail(problem);
                return text;
            }
        }
        return std::move(fixed.text);
    }

    // Counts everything; leaves in the report what is to be printed.
    void count(driver::FileReport& report) {
        std::erase_if(report.diagnostics, [this, &report](const source::Diagnostic& finding) {
            // A mesh that several scenes use is reported once.
            if (finding.span.valid() && finding.span.source != report.scene &&
                !seen_assets_
                     .emplace(report.sources->path(finding.span.source), finding.code->code,
                              finding.span.begin, finding.message)
                     .second) {
                return true;
            }
            if (finding.severity == source::Severity::kWarning) ++summary_.warnings;
            if (finding.severity == source::Severity::kError) ++summary_.errors;
            const bool hidden = summary_.errors > options_.max_errors;
            hidden_ += hidden ? 1 : 0;
            if (!hidden && first_code_.empty()) first_code_ = finding.code->code;
            return hidden;
        });
    }

    /// For people who do not know a code: where its page is.
    [[nodiscard]] std::string hint() const {
        if (first_code_.empty()) return "";
        return "more about a code in brackets: `cobble explain " + first_code_ + "`\n";
    }

    [[nodiscard]] std::string hidden_text() const {
        return hidden_ == 0 ? "" : " (" + std::to_string(hidden_) + " not shown)";
    }

    const Options& options_;
    Context& context_;
    driver::DiskFileSource disk_;
    driver::SeverityRules rules_;
    std::unique_ptr<driver::Reporter> reporter_;
    driver::Summary summary_;
    std::set<std::tuple<std::string, std::string, std::uint32_t, std::string>> seen_assets_;
    std::uint64_t hidden_ = 0;
    std::string first_code_;  ///< of what is printed
    bool fixing_;
    bool failed_ = false;
};

}  // namespace

void add_lint(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("lint", "Check scenes and say what is wrong with them");
    sub->add_option("PATH", options->paths, "Files, folders, or - for standard input")->required();
    add_choice(*sub, "--format", options->format, {"human", "json", "jsonl", "sarif", "github"},
               "How findings are printed");
    sub->add_flag("--fix", options->fix, "Apply the safe fixes to the files");
    sub->add_flag("--unsafe-fixes", options->unsafe_fixes,
                  "Apply those too that change what the scene means; implies --fix");
    sub->add_flag("--diff", options->diff,
                  "Print what --fix would change, as a unified diff, and change nothing");
    require_whole(sub->add_option("--max-errors", options->max_errors,
                                  "Stop printing after N errors, but count"),
                  0, std::numeric_limits<std::uint64_t>::max())
        ->type_name("N");
    add_list(*sub, "--deny", options->denied, "Treat this diagnostic as an error")
        ->type_name("CODE");
    add_list(*sub, "--allow", options->allowed, "Drop this diagnostic")->type_name("CODE");
    add_stdin_path(*sub, options->stdin_path);
    sub->callback([options, &context] {
        context.run = [options, &context] { return Lint(*options, context).run(); };
    });
}

}  // namespace cobble
