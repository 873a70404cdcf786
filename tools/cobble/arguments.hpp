// SPDX-License-Identifier: MIT
// Kinds of command-line options, and what several commands share in reading them.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cobble {

/// An option that may be given several times, each time with one value or several with commas.
CLI::Option* add_list(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                      const std::string& description);

/// An option whose value is one of a few words.
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string>& choices, const std::string& description);

/// An option whose value `take` reads; `wants` says what it takes ("WxH, such as 640x480") if that
/// gives false.
CLI::Option* add_parsed(CLI::App& app, const std::string& name, const std::string& type,
                        const std::string& wants, std::function<bool(std::string_view)> take,
                        const std::string& description);

/// The same for a parser that gives nothing where the text is wrong.
template <typename Value, typename Target>
CLI::Option* add_parsed(CLI::App& app, const std::string& name, const std::string& type,
                        const std::string& wants, std::optional<Value> (*parse)(std::string_view),
                        Target& target, const std::string& description) {
    const auto take = [parse, &target](std::string_view text) {
        const std::optional<Value> value = parse(text);
        if (value) target = *value;
        return value.has_value();
    };
    return add_parsed(app, name, type, wants, take, description);
}

/// Lets an option take whole numbers from `low` to `high` only, written in decimal.
CLI::Option* require_whole(CLI::Option* option, std::uint64_t low, std::uint64_t high);

/// Lets an option take finite numbers from `low` to `high` only, or only above `low`.
CLI::Option* require_number(CLI::Option* option, double low,
                            double high = std::numeric_limits<double>::infinity());
CLI::Option* require_above(CLI::Option* option, double low);

/// Where standard input is taken to be.
void add_stdin_path(CLI::App& app, std::string& path);

/// "; did you mean 'X'?" with the one of `names` that is nearest to `name`, or "" if none is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& names);

/// The same among the codes of diagnostics.
std::string similar_code(std::string_view name);

/// False, after complaining, if --stdin-filepath was given (`stdin_path` is not empty) although
/// standard input ("-") is not among `paths`.
bool stdin_path_is_used(std::string_view command, std::string_view stdin_path,
                        const std::vector<std::string>& paths);

}  // namespace cobble
