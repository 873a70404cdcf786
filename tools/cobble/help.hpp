// SPDX-License-Identifier: MIT
// How help texts look.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace cobble {

/// Descriptions are wrapped, and a flag that has a negative form is shown with it plainly.
class HelpFormatter : public CLI::Formatter {
  public:
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override;
    std::string make_option_name(const CLI::Option* option, bool is_positional) const override;
    std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace cobble
