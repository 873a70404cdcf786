// SPDX-License-Identifier: MIT
#include "tools/cobble/help.hpp"

#include <string_view>
#include <utility>

namespace cobble {
namespace {

// With the 30 columns of the names, less than a hundred.
constexpr std::size_t kDescriptionWidth = 66;

}  // namespace

std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
    std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
    // The group of options that are left out of the help leaves a blank line behind.
    constexpr std::string_view kTwoBlank = "\n\n\n";
    for (auto at = help.find(kTwoBlank); at != std::string::npos; at = help.find(kTwoBlank, at)) {
        help.erase(at, 1);
    }
    return help;
}

std::string HelpFormatter::make_option_name(const CLI::Option* option, bool is_positional) const {
    std::string name = CLI::Formatter::make_option_name(option, is_positional);
    constexpr std::string_view kNegative = "{false}";
    if (const auto at = name.find(kNegative); at != std::string::npos) {
        name.erase(at, kNegative.size());
    }
    return name;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
    std::string text = CLI::Formatter::make_option_desc(option);
    std::size_t line = 0;
    while (text.size() - line > kDescriptionWidth) {
        const std::size_t space = text.rfind(' ', line + kDescriptionWidth);
        if (space == std::string::npos || space <= line) break;
        text[space] = '\n';
        line = space + 1;
    }
    return text;
}

}  // namespace cobble
