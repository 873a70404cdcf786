// SPDX-License-Identifier: MIT
// What is said of a command line that is wrong: "cobble render: '--size' wants WxH, such as
// 640x480, not 'abc'", and where to read more.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace cobble {

/// Writes both lines to standard error; `command` is empty for the program itself. Gives kFailure.
int usage_error(std::string_view command, std::string_view problem);

/// What is wrong, in our words whatever the option library calls it.
std::string usage_problem(const CLI::App& command, const CLI::ParseError& error);

/// "'-o' wants a value: FILE" if an option that takes one is followed by another option, which the
/// option library would take for the value; or "". `arguments` begin with the command.
std::string missing_value(const CLI::App& app, const std::vector<std::string>& arguments);

/// Of a command line that parses: "'--quiet' is given twice", or "" if no option is that takes no
/// list. The option library refuses most of these itself, but no flag.
std::string repeated_option(const CLI::App& command);

}  // namespace cobble
