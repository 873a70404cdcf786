// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frontend/format/format.hpp"
#include "frontend/source/utf8.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/interrupt.hpp"
#include "tools/cobble/option_values.hpp"
#include "tools/cobble/usage.hpp"
#include "tools/driver/session.hpp"
#include "tools/driver/text.hpp"
#include "tools/driver/unified_diff.hpp"
#include "tools/driver/walk.hpp"
#include "tools/driver/write_file.hpp"

namespace cobble {
namespace {

struct Options {
    std::vector<std::string> paths;
    std::optional<LineRange> range;
    std::string stdin_path;
    bool check = false;
    bool diff = false;
};

class Format {
  public:
    Format(const Options& options, Context& context) : options_(options), context_(context) {}

    int run() {
        if (options_.range) format_options_ = {options_.range->first, options_.range->last};
        if (!stdin_path_is_used("fmt", options_.stdin_path, options_.paths)) return kFailure;
        const driver::SceneFiles files = driver::find_scenes(options_.paths);
        for (const std::string& problem : files.problems) fail(problem);
        if (options_.range && files.paths.size() > 1) {
            return usage_error("fmt", "'--range' takes one file");
        }
        for (const std::string& path : files.paths) {
            format(path);
            if (InterruptGuard::interrupted()) {
                driver::complain("interrupted; the files not yet reached are as they were");
                return kInterrupted;
            }
        }
        if (failed_) return kFailure;
        if (refused_) return kInternal;
        return broken_ || (options_.check && differs_) ? kFindings : kDone;
    }

  private:
    void fail(std::string_view problem) {
        context_.out.flush();
        driver::complain(problem);
        failed_ = true;
    }

    [[nodiscard]] std::string_view what_errors_mean(const frontend::FormatResult& result) const {
        if (options_.check) return "the layout of the broken blocks is not checked";
        if (result.left_alone) return "they leave open what belongs where, so it stays as it is";
        return "the broken blocks are left as they are";
    }

    void format(const std::string& argument) {
        const bool standard_input = argument == "-";
        const driver::ReadText file =
            standard_input ? driver::read_standard_input() : driver::read_text(argument);
        if (!file.problem.empty()) return fail(file.problem);
        std::string path = argument;
        if (standard_input) path = options_.stdin_path.empty() ? "<stdin>" : options_.stdin_path;

        // Another program's file, named by mistake, is not to be mended into nothing.
        if (const std::string reason = source::why_not_text(file.text); !reason.empty()) {
            return fail(fmt::format("{} is not text: {}", path, reason));
        }
        const frontend::FormatResult result = frontend::format(file.text, format_options_);
        if (result.refused) {
            refused_ = true;
            driver::complain(fmt::format(
                "internal error: {} would have lost something in formatting and is left as it is "
                "({})",
                path, result.refusal));
        } else if (result.has_errors) {
            broken_ = true;
            driver::complain(fmt::format("{} has errors: {} (`cobble lint` says where)", path,
                                         what_errors_mean(result)));
        }
        const bool differs = result.text != file.text;
        differs_ = differs_ || differs;
        if (options_.diff) {
            const driver::DiffStyle style{driver::wants_color(STDOUT_FILENO)};
            context_.out.write(driver::unified_diff(file.text, result.text, path, path, style));
        } else if (options_.check) {
            if (differs) context_.out.write(driver::printable(path) + "\n");
        } else if (standard_input) {
            context_.out.write(result.text);
        } else if (differs) {
            // An interrupt waits until the file is whole; before, there is nothing to save.
            const InterruptGuard guard;
            const std::string problem = driver::write_file(path, result.text);
            if (!problem.empty()) fail(problem);
        }
    }

    const Options& options_;
    Context& context_;
    frontend::FormatOptions format_options_;
    bool differs_ = false;
    bool broken_ = false;
    bool refused_ = false;
    bool failed_ = false;
};

}  // namespace

void add_fmt(CLI::App& app, Context& context) {
    auto options = std::make_shared<Options>();
    CLI::App* sub = app.add_subcommand("fmt", "Format scenes in place");
    sub->add_option("PATH", options->paths,
                    "Files, folders, or - to format standard input to standard output")
        ->required();
    sub->add_flag("--check", options->check,
                  "Change nothing; print the files that would change, and exit with 1 if any");
    sub->add_flag("--diff", options->diff,
                  "Change nothing; print what would change, as a unified diff");
    add_parsed(*sub, "--range", "L1:L2", "L1:L2 with 1 <= L1 <= L2, such as 10:20", parse_lines,
               options->range, "Format only these lines, from 1 and inclusive");
    sub->add_option("--stdin-filepath", options->stdin_path, "What messages call standard input")
        ->type_name("P");
    sub->footer(
        "A file is replaced whole, so that nothing can leave half of it. Symbolic links are "
        "followed; of\nseveral hard links to one file only the one that was named is replaced.");
    sub->callback([options, &context] {
        context.run = [options, &context] { return Format(*options, context).run(); };
    });
}

}  // namespace cobble
