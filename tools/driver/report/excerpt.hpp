// SPDX-License-Identifier: MIT
// A line of a file with carets under a place.
#pragma once

#include <string>
#include <string_view>

#include "frontend/source/span.hpp"
#include "tools/driver/report/positions.hpp"
#include "tools/driver/report/reporter.hpp"

namespace cobble::driver {

/// `text` between the escapes of a colour ("1;31"), if colour is on.
std::string painted(std::string_view color, std::string_view text, const ReportStyle& style);

/// "  6 |     angles 30" and the carets below, in `caret_color`; nothing for a place without text.
/// A line too long for the style is cut around the place.
std::string excerpt_of(source::Span span, Positions& positions, const ReportStyle& style,
                       std::string_view caret_color);

}  // namespace cobble::driver
