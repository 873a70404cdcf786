// SPDX-License-Identifier: MIT
// The reporters, one file each.
#pragma once

#include <memory>
#include <string_view>

#include "frontend/source/diagnostic.hpp"
#include "tools/driver/report/reporter.hpp"

namespace cobble::driver {

std::unique_ptr<Reporter> make_human_reporter(const ReportStyle& style, Sink sink);
std::unique_ptr<Reporter> make_json_reporter(Sink sink);
std::unique_ptr<Reporter> make_json_lines_reporter(Sink sink);
std::unique_ptr<Reporter> make_sarif_reporter(Sink sink);
std::unique_ptr<Reporter> make_github_reporter(Sink sink);

/// "error", "warning" or "info".
std::string_view name_of(source::Severity severity);

}  // namespace cobble::driver
