// SPDX-License-Identifier: MIT
// Well-formed UTF-8 as Unicode's table 3-7 defines it: no overlong forms, no surrogates, nothing
// above U+10FFFF.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cobble::source {

/// Length in bytes of the code point at the front of `text`, or 0 if none starts there (which is
/// so for an empty text too).
std::size_t utf8_length(std::string_view text);

/// True if all bytes are below 0x80. Cost: eight bytes at a time.
bool is_ascii(std::string_view text);

/// True if the bytes are plainly no UTF-8 text: a byte-order mark of UTF-16 at the front, or a zero
/// byte within the first 8 KiB (as Git tells binary files from text).
bool looks_binary(std::string_view text);

/// Why `bytes` are not text in UTF-8: "it is UTF-16, not UTF-8", "zero byte at offset 8" or
/// "invalid UTF-8 at offset 3", whichever comes first; empty if they are.
std::string why_not_text(std::string_view bytes);

}  // namespace cobble::source
