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

bool is_deeper(std::string_view indent, std::string_view than) {
    return indent.size() > than.size() && indent.starts_with(than);
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
    const auto of_item = indent_of(tokens, item);
    const bool item_is_inside = of_opener && of_item && is_deeper(*of_item, *of_opener);
    if (of_brace) return of_opener && (is_deeper(*of_brace, *of_opener) || item_is_inside);
    // A } behind other things: what follows goes on with the same line, or is indented as inside.
    return !of_item || item_is_inside;
}

}  // namespace cobble::frontend
