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

#include "frontend/names/suggest.hpp"
#include "tools/cobble/command.hpp"
#include "tools/cobble/help.hpp"
#include "tools/cobble/interrupt.hpp"
#include "tools/cobble/old_spellings.hpp"

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
        "`cobble COMMAND --help` tells more of a command. The original programs' spelling works "
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
    const std::string_view similar = frontend::nearest_name(first, views);
    std::string text = "there is no command '" + first + "'";
    if (!similar.empty()) text += "; did you mean '" + std::string(similar) + "'?";
    return text + " (`cobble --help` lists the commands)";
}

// Of a command line that does not parse: the first option that there is not comes before whatever
// else is wrong, as that may follow from it. "" if all are known.
std::string unknown_option(const CLI::App& app) {
    const auto chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        // Without a group it is left out of the help too.
        if (option->get_group().empty()) continue;
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    for (const std::string& argument : command.remaining()) {
        if (argument.size() < 2 || !argument.starts_with('-')) continue;
        const std::string name = argument.substr(0, argument.find('='));
        const std::string_view similar = frontend::nearest_name(name, views);
        return "unknown option '" + name + "'" +
               (similar.empty() ? "" : "; did you mean '" + std::string(similar) + "'?");
    }
    return {};
}

// CLI11 does not name an option that is left out of the help; -blurry is the only one of them that
// takes a value.
std::string with_name(const std::string& message) {
    return message.starts_with(": ") ? "-blurry" + message : message;
}

int finish(Context& context, int status) {
    context.out.flush();
    if (!context.out.error().empty()) {
        driver::complain("cannot write to standard output: " + context.out.error());
        return kFailure;
    }
    return context.out.closed() ? static_cast<int>(kDone) : status;
}

int run(std::vector<std::string> arguments) {
    Context context;
    CLI::App app;
    describe(app);
    for (const auto add : {add_lint, add_fmt, add_render, add_explain, add_diff, add_pick,
                           add_stability, add_ir, add_dump, add_merge}) {
        add(app, context);
    }
    if (const std::string problem = rewrite_old_spellings(arguments); !problem.empty()) {
        driver::complain(problem);
        return kFailure;
    }
    if (const std::string problem = wrong_command(app, arguments); !problem.empty()) {
        driver::complain(problem);
        return kFailure;
    }
    protect_paths(arguments);
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
        const std::string unknown = unknown_option(app);
        driver::complain(unknown.empty() ? with_name(error.what()) : unknown);
        const auto chosen = app.get_subcommands();
        const std::string name = chosen.empty() ? "" : " " + chosen.front()->get_name();
        driver::write_error("Try `cobble" + name + " --help`.\n");
        return kFailure;
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
    } catch (const std::bad_alloc&) {
        cobble::driver::complain("out of memory");
        return cobble::kFailure;
    } catch (const std::exception& error) {
        cobble::driver::complain(std::string("internal error: ") + error.what());
        return cobble::kInternal;
    }
}
