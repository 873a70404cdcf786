// SPDX-License-Identifier: MIT
#include "frontend/parse/layout.hpp"

namespace cobble::frontend {

std::optional<std::string_view> indent_of(const Tokens& tokens, std::uint32_t token) {
    if (!tokens.first_on_line({token})) return std::nullopt;
    const std::uint32_t end = tokens.tokens[token].begin;
    const std::string_view before = tokens.text.substr(0, end);
    const std::size_t line_end = before.find_last_of("\r\n");
    if (line_end != std::string_view::npos) return before.substr(line_end + 1);
    // The first line: what stands before the token is white space but for a byte-order mark.
    return before.starts_with("\xEF\xBB\xBF") ? before.substr(3) : before;
}

bool stands_beside(const Tokens& tokens, std::uint32_t item, std::uint32_t opener,
                   std::uint32_t first_child) {
    const auto indent = indent_of(tokens, item);
    return indent && indent == indent_of(tokens, opener) &&
           indent != indent_of(tokens, first_child);
}

bool close_looks_extra(const Tokens& tokens, std::uint32_t opener, std::uint32_t brace,
                       std::uint32_t item) {
    const auto of_opener = indent_of(tokens, opener);
    const auto of_brace = indent_of(tokens, brace);
    if (of_brace && of_brace != of_opener) return true;
    // A } that ends a line of other things, or stands like its opener, is extra only if what
    // follows is not where the next block should be.
    const auto of_item = indent_of(tokens, item);
    return !of_item || of_item != of_opener;
}

}  // namespace cobble::frontend
