// SPDX-License-Identifier: MIT
#include "tools/cobble/arguments.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "frontend/names/suggest.hpp"
#include "frontend/source/diagnostic.hpp"
#include "tools/cobble/usage.hpp"
#include "tools/driver/numbers.hpp"

namespace cobble {
namespace {

std::string wants_text(std::string_view wants, std::string_view text) {
    return fmt::format("wants {}, not '{}'", wants, text);
}

}  // namespace

CLI::Option* add_list(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                      const std::string& description) {
    return app.add_option(name, values, description)
        ->expected(1)
        ->allow_extra_args(false)
        ->delimiter(',')
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& choices, const std::string& description) {
    std::string shown;
    std::string listed;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        shown += (i == 0 ? "" : "|") + choices[i];
        listed += (i == 0 ? "" : i + 1 < choices.size() ? ", " : " or ") + choices[i];
    }
    const auto check = [choices, listed](const std::string& text) {
        const bool known = std::find(choices.begin(), choices.end(), text) != choices.end();
        return known ? std::string() : wants_text(listed, text);
    };
    return app.add_option(name, value, description)
        ->type_name(shown)
        ->check(check)
        ->capture_default_str();
}

CLI::Option* add_parsed(CLI::App& app, const std::string& name, const std::string& type,
                        const std::string& wants, std::function<bool(std::string_view)> take,
                        const std::string& description) {
    const auto check = [wants, take = std::move(take)](const std::string& text) {
        return take(text) ? std::string() : wants_text(wants, text);
    };
    // The check has taken the value already.
    return app
        .add_option_function<std::string>(
            name, [](const std::string&) {}, description)
        ->type_name(type)
        ->check(check);
}

CLI::Option* require_whole(CLI::Option* option, std::uint64_t low, std::uint64_t high) {
    const auto check = [low, high](std::string& text) {
        std::uint64_t number = 0;
        if (!driver::parse_number(text, number) || number < low || number > high) {
            return wants_text(fmt::format("a whole number from {} to {}", low, high), text);
        }
        // CLI11 would take a leading 0 for a number to the base 8.
        text = std::to_string(number);
        return std::string();
    };
    return option->transform(CLI::Validator(check, ""));
}

CLI::Option* require_number(CLI::Option* option, double low, double high) {
    return option->check([low, high](const std::string& text) {
        double number = 0;
        if (driver::parse_number(text, number) && number >= low && number <= high) {
            return std::string();
        }
        return wants_text(std::isinf(high) ? fmt::format("a number of {} or more", low)
                                           : fmt::format("a number from {} to {}", low, high),
                          text);
    });
}

CLI::Option* require_above(CLI::Option* option, double low) {
    return option->check([low](const std::string& text) {
        double number = 0;
        if (driver::parse_number(text, number) && number > low) return std::string();
        return wants_text(fmt::format("a number above {}", low), text);
    });
}

void add_stdin_path(CLI::App& app, std::string& path) {
    app.add_option("--stdin-filepath", path,
                   "Where standard input is taken to be: paths in it start there")
        ->type_name("P");
}

std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& names) {
    const std::string_view similar = frontend::nearest_name(name, names);
    return similar.empty() ? std::string() : fmt::format("; did you mean '{}'?", similar);
}

std::string similar_code(std::string_view name) {
    std::vector<std::string_view> names;
    for (const auto* code : source::all_codes()) names.push_back(code->code);
    return did_you_mean(name, names);
}

bool stdin_path_is_used(std::string_view command, std::string_view stdin_path,
                        const std::vector<std::string>& paths) {
    if (stdin_path.empty() || std::find(paths.begin(), paths.end(), "-") != paths.end()) {
        return true;
    }
    usage_error(command,
                "'--stdin-filepath' says where standard input is taken to be: it goes with the "
                "path -");
    return false;
}

}  // namespace cobble
