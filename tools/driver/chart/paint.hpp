// SPDX-License-Identifier: MIT
// The colours of charts, by their task.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cobble::driver::chart {

/// Blue and vermilion are two of Okabe and Ito's "Color Universal Design" (2008): they and grey
/// stay apart for all common kinds of colour blindness, and have a contrast of at least 3.8:1 with
/// the paper, light or dark. Charts never tell things apart by colour alone: marks, dashes or
/// places differ too.
enum class Paint : std::uint8_t {
    kPaper,
    kInk,    ///< text and data without a colour of its own
    kSoft,   ///< numbers at the axes, captions
    kGrid,   ///< lines at labelled ticks, the frame
    kFaint,  ///< lines at the ticks between
    kBlue,
    kVermilion,
    kGrey,  ///< data that matters less
    kCount_
};

/// As "#rrggbb", on white paper.
std::string_view color_of(Paint paint);

/// The class names that elements painted so carry, as "fill-blue" and "stroke-blue".
std::string_view name_of(Paint paint);

/// CSS that turns the charts inside elements of this class dark, for pages with a dark look; one
/// rule a line, each line indented by `indent`.
std::string dark_rules(std::string_view selector, std::string_view indent);

}  // namespace cobble::driver::chart
