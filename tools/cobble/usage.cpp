// SPDX-License-Identifier: MIT
#include "tools/cobble/usage.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <vector>

#include "tools/cobble/arguments.hpp"
#include "tools/cobble/command.hpp"

namespace cobble {
namespace {

std::string shown(const CLI::Option& option) {
    // The original programs' spellings are rewritten to these.
    constexpr std::string_view kOriginal = "original-";
    if (!option.get_lnames().empty() && option.get_lnames().front().starts_with(kOriginal)) {
        return "'-" + option.get_lnames().front().substr(kOriginal.size()) + "'";
    }
    const std::string name = option.get_name();
    return name.starts_with('-') ? "'" + name + "'" : name;
}

// Of a command line that does not parse: the first option that there is not comes before whatever
// else is wrong, as that may follow from it. "" if all are known.
std::string unknown_option(const CLI::App& command) {
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
        return "there is no option '" + name + "'" + did_you_mean(name, views);
    }
    return {};
}

// "SCENE is missing: the scene file, or - for standard input".
std::string missing(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_required() || option->count() > 0) continue;
        std::string description = option->get_description();
        if (!description.empty() && description[0] >= 'A' && description[0] <= 'Z') {
            description[0] = static_cast<char>(description[0] - 'A' + 'a');
        }
        return fmt::format("{} is missing: {}", shown(*option), description);
    }
    return {};
}

// The option that the library's message begins with, past `before`.
const CLI::Option* option_of(const CLI::App& command, std::string_view message,
                             std::string_view before = {}) {
    if (!message.starts_with(before)) return nullptr;
    message.remove_prefix(before.size());
    const std::string name(message.substr(0, message.find_first_of(": ")));
    for (const CLI::Option* option : command.get_options()) {
        // The library leaves the dashes of a flag's negative form out.
        if (name.empty()) continue;
        if (option->check_name(name) || option->check_name("--" + name)) return option;
    }
    return nullptr;
}

std::string too_often(const CLI::Option& option) {
    const std::vector<std::string>& values = option.results();
    // A flag and its negative form.
    if (option.get_expected_max() == 0 && !option.get_fnames().empty() &&
        std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) != values.end()) {
        return fmt::format("{} and '--{}' are both given", shown(option),
                           option.get_fnames().front());
    }
    if (option.count() == 2) return shown(option) + " is given twice";
    return fmt::format("{} is given {} times", shown(option), option.count());
}

std::string of_counts(const CLI::App& command, std::string_view message) {
    const CLI::Option* option = option_of(command, message);
    if (option == nullptr) return {};
    if (option->count() > 1) return too_often(*option);
    // A flag cannot have too few of what it does not take.
    if (option->get_expected_max() == 0) return shown(*option) + " takes no value";
    return fmt::format("{} wants a value: {}", shown(*option), option->get_type_name());
}

}  // namespace

int usage_error(std::string_view command, std::string_view problem) {
    const std::string name = command.empty() ? "cobble" : "cobble " + std::string(command);
    driver::complain(problem, command);
    driver::write_error("Try `" + name + " --help`.\n");
    return kFailure;
}

std::string missing_value(const CLI::App& app, const std::vector<std::string>& arguments) {
    const CLI::App* command = nullptr;
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (!arguments.empty() && sub->get_name() == arguments.front()) command = sub;
    }
    if (command == nullptr) return {};
    const auto find = [command](const std::string& word) -> const CLI::Option* {
        return word.starts_with('-') && word.size() > 1 ? command->get_option_no_throw(word)
                                                        : nullptr;
    };
    for (std::size_t i = 1; i + 1 < arguments.size(); ++i) {
        const CLI::Option* option = find(arguments[i]);
        if (option == nullptr || option->get_expected_max() == 0) continue;
        ++i;  // its value
        if (find(arguments[i]) == nullptr) continue;
        return fmt::format("'{}' wants a value: {}", arguments[i - 1], option->get_type_name());
    }
    return {};
}

std::string repeated_option(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        // A flag has this policy too, to count how often it is given.
        const bool list = option->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll &&
                          option->get_expected_max() > 0;
        if (option->nonpositional() && !list && option->count() > 1) return too_often(*option);
    }
    return {};
}

std::string usage_problem(const CLI::App& command, const CLI::ParseError& error) {
    const std::string message = error.what();
    std::string problem = unknown_option(command);
    if (problem.empty() && dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
        problem = missing(command);
    }
    if (problem.empty() && dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        problem = of_counts(command, message);
    }
    if (problem.empty() && dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
        // Values are looked at before they are converted: only flags come so far.
        const CLI::Option* option = option_of(command, message, "Could not convert: ");
        if (option != nullptr) problem = shown(*option) + " takes no value";
    }
    if (problem.empty() && dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
        const std::vector<std::string> rest = command.remaining();
        if (!rest.empty()) problem = "'" + rest.front() + "' is one argument too many";
    }
    if (problem.empty() && dynamic_cast<const CLI::ValidationError*>(&error) != nullptr) {
        // "NAME: wants ...": no NAME where the option is left out of the help.
        const std::size_t end = message.find(": ");
        const CLI::Option* option = option_of(command, message);
        if (option == nullptr) option = command.get_option_no_throw("--original-blurry");
        if (option != nullptr && end != std::string::npos) {
            problem = shown(*option) + " " + message.substr(end + 2);
        }
    }
    return problem.empty() ? message : problem;
}

}  // namespace cobble
