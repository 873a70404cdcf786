// SPDX-License-Identifier: MIT
#include "frontend/ast/edits.hpp"

namespace cobble::frontend {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool ends_line(char c) { return c == '\n' || c == '\r'; }

}  // namespace

ByteRange removal_range(const Tokens& tokens, TokenId first, TokenId last) {
    const std::string_view text = tokens.text;
    const ByteRange own{tokens.range(first).begin, tokens.range(last).end};
    std::uint32_t begin = own.begin;
    std::uint32_t end = own.end;
    while (begin > 0 && is_blank(text[begin - 1])) --begin;
    while (end < text.size() && is_blank(text[end])) ++end;
    const bool starts = begin == 0 || ends_line(text[begin - 1]);
    const bool stops = end == text.size() || ends_line(text[end]);
    if (starts && stops) {
        if (end < text.size()) end += text.substr(end, 2) == "\r\n" ? 2 : 1;
        return {begin, end};
    }
    return {starts ? own.begin : begin, starts ? end : own.end};
}

}  // namespace cobble::frontend
