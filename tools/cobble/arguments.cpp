// SPDX-License-Identifier: MIT
#include "tools/cobble/arguments.hpp"

#include <fast_float/fast_float.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "frontend/names/suggest.hpp"
#include "frontend/source/diagnostic.hpp"
#include "tools/driver/output.hpp"

namespace cobble {
namespace {

bool parse_one(std::string_view text, std::uint32_t& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size();
}

bool parse_one(std::string_view text, double& number) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] =
        fast_float::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

template <typename Number>
bool parse_all(std::string_view text, char separator, std::size_t count,
               std::vector<Number>& numbers) {
    numbers.clear();
    for (;;) {
        const std::size_t end = std::min(text.find(separator), text.size());
        Number number{};
        if (!parse_one(text.substr(0, end), number)) return false;
        numbers.push_back(number);
        if (end == text.size()) break;
        text.remove_prefix(end + 1);
    }
    return numbers.size() == count;
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
    for (const std::string& choice : choices) shown += (shown.empty() ? "" : "|") + choice;
    const auto check = [choices, shown](const std::string& text) {
        const bool known = std::find(choices.begin(), choices.end(), text) != choices.end();
        return known ? std::string() : "'" + text + "' is none of " + shown;
    };
    return app.add_option(name, value, description)
        ->type_name(shown)
        ->check(check)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
        ->capture_default_str();
}

std::string similar_code(std::string_view name) {
    std::vector<std::string_view> names;
    for (const auto* code : source::all_codes()) names.push_back(code->code);
    const auto similar = frontend::nearest_name(name, names);
    return similar.empty() ? std::string() : "; did you mean '" + std::string(similar) + "'?";
}

bool stdin_path_is_used(std::string_view stdin_path, const std::vector<std::string>& paths) {
    if (stdin_path.empty() || std::find(paths.begin(), paths.end(), "-") != paths.end()) {
        return true;
    }
    driver::complain(
        "--stdin-filepath says where standard input is taken to be: it goes with the "
        "path -");
    return false;
}

bool parse_numbers(std::string_view text, char separator, std::size_t count,
                   std::vector<std::uint32_t>& numbers) {
    return parse_all(text, separator, count, numbers);
}

bool parse_numbers(std::string_view text, char separator, std::size_t count,
                   std::vector<double>& numbers) {
    return parse_all(text, separator, count, numbers);
}

}  // namespace cobble
