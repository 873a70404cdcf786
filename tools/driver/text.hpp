// SPDX-License-Identifier: MIT
// Text as a terminal shows it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cobble::driver {

/// One code point at the front of a text. Bytes that are not UTF-8 count one each, as U+FFFD.
struct CodePoint {
    std::uint32_t value = 0;
    std::uint32_t bytes = 0;  ///< 0 at the end of the text
};
CodePoint next_code_point(std::string_view text);

/// Columns that a terminal gives to a code point: 0 for combining marks and other invisible ones, 2
/// for East Asian wide ones and emoji, else 1. After Unicode 15 (EastAsianWidth.txt,
/// DerivedGeneralCategory.txt), in ranges that are generous where blocks have gaps.
unsigned width_of(std::uint32_t code_point);

/// `text` made safe to print: bytes that are not UTF-8 and control characters become U+FFFD, so
/// that no file can send commands to a terminal. Tabs become a space.
std::string printable(std::string_view text);

}  // namespace cobble::driver
