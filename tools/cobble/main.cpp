// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/accel/tree_limits.hpp"
#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/help.hpp"
#include "tools/cobble/interrupt.hpp"
#include "tools/cobble/old_spellings.hpp"
#include "tools/cobble/usage.hpp"

namespace cobble {
namespace {

void describe(CLI::App& app) {
    app.description("Cobble: lints, formats and renders scenes of a ray-tracing language.");
    app.set_version_flag("--version", "cobble " COBBLE_VERSION, "Print the version and exit");
    app.set_help_flag("-h,--help", "Print this help and exit");
    app.name("cobble");
    app.formatter(std::make_shared<HelpFormatter>());
    app.require_subcommand(1);
    app.footer(
        "`cobble help COMMAND` tells more of a command. The original programs' spelling works "
        "too:\n`cobble -input FILE -output FILE -size W H ...`.\n\n"
        "Exit status: 0 done and clean; 1 findings; 2 usage, missing files, reading or writing; "
        "3 internal\nerror; 130 interrupted.");
}

// CLI11 would take an argument in brackets for a list, which no path is, and it does not know that
// behind "--" nothing is an option.
void protect_paths(std::vector<std::string>& arguments) {
    bool only_paths = false;
    std::vector<std::string> result;
    for (std::string& argument : arguments) {
        if (argument == "--" && !only_paths) {
            only_paths = true;
            continue;
        }
        const bool brackets = argument.starts_with('[') && argument.ends_with(']');
        const bool dash = only_paths && argument.size() > 1 && argument.starts_with('-');
        if (brackets || dash) argument.insert(0, "./");
        result.push_back(std::move(argument));
    }
    arguments = std::move(result);
}

// `cobble help` and `cobble help COMMAND` are other words for --help.
std::string rewrite_help(std::vector<std::string>& arguments) {
    if (arguments.empty() || arguments.front() != "help") return {};
    if (arguments.size() > 2) return "'" + arguments[2] + "' is one argument too many";
    arguments.erase(arguments.begin());
    if (!arguments.empty() && arguments.front() == "help") arguments.clear();
    if (arguments.empty() || arguments.front() != "--help") arguments.emplace_back("--help");
    return {};
}

// "" if the command line begins with an option or a command that there is.
std::string wrong_command(const CLI::App& app, const std::vector<std::string>& arguments) {
    if (arguments.empty()) return "say what to do: `cobble --help` lists the commands";
    const std::string& first = arguments.front();
    if (first.starts_with('-')) return {};
    std::vector<std::string> names;
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(sub->get_name());
    }
    if (std::find(names.begin(), names.end(), first) != names.end()) return {};
    const std::vector<std::string_view> views(names.begin(), names.end());
    return "there is no command '" + first + "'" + did_you_mean(first, views) +
           " (`cobble --help` lists the commands)";
}

int finish(Context& context, int status) {
    context.out.flush();
    if (!context.out.error().empty()) {
        driver::complain("cannot write to standard output: " + context.out.error());
        return kFailure;
    }
    // A reader that has gone away is no error, and takes none away that was found.
    return status;
}

int run(std::vector<std::string> arguments) {
    Context context;
    CLI::App app;
    describe(app);
    for (const auto add : {add_lint, add_fmt, add_render, add_explain, add_diff, add_pick,
                           add_stability, add_cost, add_ir, add_dump, add_merge, add_lsp}) {
        add(app, context);
    }
    if (const std::string problem = rewrite_old_spellings(arguments); !problem.empty()) {
        return usage_error("render", problem);
    }
    if (const std::string problem = rewrite_help(arguments); !problem.empty()) {
        return usage_error("", problem);
    }
    if (const std::string problem = wrong_command(app, arguments); !problem.empty()) {
        driver::complain(problem);
        return kFailure;
    }
    protect_paths(arguments);
    if (const std::string problem = missing_value(app, arguments); !problem.empty()) {
        return usage_error(arguments.front(), problem);
    }
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::CallForHelp&) {
        context.out.write(app.help());
        return finish(context, kDone);
    } catch (const CLI::CallForVersion& version) {
        context.out.write(std::string(version.what()) + "\n");
        return finish(context, kDone);
    } catch (const CLI::ParseError& error) {
        const auto chosen = app.get_subcommands();
        const CLI::App& command = chosen.empty() ? app : *chosen.front();
        return usage_error(chosen.empty() ? "" : command.get_name(), usage_problem(command, error));
    }
    const CLI::App& command = *app.get_subcommands().front();
    if (const std::string problem = repeated_option(command); !problem.empty()) {
        return usage_error(command.get_name(), problem);
    }
    return finish(context, context.run());
}

}  // namespace
}  // namespace cobble

int main(int argc, char** argv) {
    cobble::driver::prepare_streams();
    cobble::exit_on_interrupt();
    try {
        return cobble::run(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
    } catch (const cobble::renderer::TooManyThings& problem) {
        cobble::driver::complain(problem.what());
        return cobble::kFailure;
    } catch (const std::bad_alloc&) {
        cobble::driver::complain("out of memory");
        return cobble::kFailure;
    } catch (const std::exception& error) {
        cobble::driver::complain(std::string("internal error: ") + error.what());
        return cobble::kInternal;
    }
}
