// SPDX-License-Identifier: MIT
#include "frontend/lex/words.hpp"

#include <algorithm>

namespace cobble::frontend {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool equals_ignoring_case(std::string_view word, std::string_view lower) {
    const auto same = [](char a, char b) { return a == b || (is_letter(a) && (a | 0x20) == b); };
    return word.size() == lower.size() && std::equal(word.begin(), word.end(), lower.begin(), same);
}

}  // namespace

bool looks_like_number(std::string_view word) {
    while (!word.empty() && (word[0] == '+' || word[0] == '-')) word.remove_prefix(1);
    if (word.empty()) return false;
    if (word[0] == '.' || word[0] == ',') word.remove_prefix(1);
    if (!word.empty() && is_digit(word[0])) return true;
    return equals_ignoring_case(word, "inf") || equals_ignoring_case(word, "infinity") ||
           equals_ignoring_case(word, "nan");
}

bool is_label(std::string_view word) {
    if (word.empty() || is_digit(word[0]) || word[0] == '-') return false;
    return std::all_of(word.begin(), word.end(),
                       [](char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '-'; });
}

}  // namespace cobble::frontend
