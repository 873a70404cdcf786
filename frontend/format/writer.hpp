// SPDX-License-Identifier: MIT
// A layout as text. Input: tokens and gaps. Output: bytes into a sink. Invariant: every byte of a
// token goes out as it came in, and every comment but for the blanks at its end.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "frontend/format/layout.hpp"
#include "frontend/lex/tokens.hpp"

namespace cobble::frontend {

struct WriteOptions {
    std::uint32_t first_line = 1;  ///< lines to format, 1-based and inclusive
    std::uint32_t last_line = UINT32_MAX;
};

struct WriteResult {
    /// Lines in what was written less lines in the source.
    std::int64_t lines_added = 0;
    /// False if `expected` was given and something else was written.
    bool as_expected = true;
};

/// Writes the text to `out`; it is appended to.
WriteResult write(const Tokens& tokens, const Layout& layout, const WriteOptions& options,
                  std::string& out);

/// Compares what would be written with `expected`, without keeping it.
WriteResult compare(const Tokens& tokens, const Layout& layout, const WriteOptions& options,
                    std::string_view expected);

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Where a token ends, without a call for all but the longest ones.
inline std::uint32_t end_of(const Tokens& tokens, std::uint32_t index) {
    const Token token = tokens.tokens[index];
    constexpr std::uint32_t kLongest = (1U << 24U) - 1;
    return token.length < kLongest ? token.begin + token.length : tokens.range({index}).end;
}

/// White space of the language.
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
constexpr bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// `// cobble-format off` and `// cobble-format on`: what stands between the two stays as it is.
enum class Switch : std::uint8_t { kNone, kOff, kOn };
Switch switch_of(std::string_view comment);

}  // namespace cobble::frontend
