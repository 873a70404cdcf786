// SPDX-License-Identifier: MIT
// Well-formed UTF-8 as Unicode's table 3-7 defines it: no overlong forms, no surrogates, nothing
// above U+10FFFF.
#pragma once

#include <cstddef>
#include <string_view>

namespace cobble::source {

/// Length in bytes of the code point at the front of `text`, or 0 if none starts there (which is
/// so for an empty text too).
std::size_t utf8_length(std::string_view text);

/// True if all bytes are below 0x80. Cost: eight bytes at a time.
bool is_ascii(std::string_view text);

}  // namespace cobble::source
