// SPDX-License-Identifier: MIT
#include "frontend/ast/numbers.hpp"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "frontend/ast/reporter.hpp"

namespace cobble::frontend {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

int hex_digit(char c) {
    if (is_digit(c)) return c - '0';
    return (c | 0x20) - 'a' + 10;
}

// The longest prefix that is a number by the lexical grammar; 0 if there is none.
std::size_t number_prefix(std::string_view word) {
    std::size_t at = 0;
    const auto digits = [&word, &at] {
        const std::size_t begin = at;
        while (at < word.size() && is_digit(word[at])) ++at;
        return at - begin;
    };
    if (at < word.size() && (word[at] == '+' || word[at] == '-')) ++at;
    std::size_t count = digits();
    if (at < word.size() && word[at] == '.') {
        ++at;
        count += digits();
    }
    if (count == 0) return 0;
    const std::size_t mantissa = at;
    if (at < word.size() && (word[at] == 'e' || word[at] == 'E')) {
        ++at;
        if (at < word.size() && (word[at] == '+' || word[at] == '-')) ++at;
        if (digits() > 0) return at;
    }
    return mantissa;
}

bool is_number(std::string_view word) {
    return !word.empty() && number_prefix(word) == word.size();
}

bool contains_letter_of(std::string_view word, std::string_view letters) {
    return word.find_first_of(letters) != std::string_view::npos;
}

}  // namespace

ParsedNumber parse_number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    ParsedNumber parsed;
    fast_float::from_chars(text.data(), text.data() + text.size(), parsed.value);
    if (!std::isfinite(parsed.value)) {
        parsed.range = NumberRange::kTooLarge;
    } else if (parsed.value == 0) {
        const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
        const bool zero = mantissa.find_first_of("123456789") == std::string_view::npos;
        if (!zero) parsed.range = NumberRange::kTooSmall;
    }
    return parsed;
}

std::array<double, 3> parse_color(std::string_view text) {
    std::array<double, 3> color{};
    for (std::size_t i = 0; i < 3; ++i) {
        const int byte = hex_digit(text[1 + 2 * i]) * 16 + hex_digit(text[2 + 2 * i]);
        color[i] = byte / 255.0;
    }
    return color;
}

MalformedNumber explain_malformed(std::string_view word) {
    const std::string shown = quoted(word);
    std::string_view body = word;
    while (!body.empty() && (body[0] == '+' || body[0] == '-')) body.remove_prefix(1);
    const std::size_t signs = word.size() - body.size();
    if (!body.empty() && (body[0] | 0x20) == 'i') {
        return {fmt::format("{} is no number: a scene has no infinite values", shown), {}};
    }
    if (!body.empty() && (body[0] | 0x20) == 'n') {
        return {fmt::format("{} is no number: a scene has no undefined values", shown), {}};
    }
    if (body.starts_with("0x") || body.starts_with("0X")) {
        return {
            fmt::format("hexadecimal {} is no number of the language, write it in decimal", shown),
            {}};
    }
    if (signs > 1) return {fmt::format("{} has more than one sign", shown), {}};
    if (std::count(word.begin(), word.end(), ',') == 1) {
        const std::size_t comma = word.find(',');
        const std::string_view left = word.substr(0, comma);
        const std::string_view right = word.substr(comma + 1);
        if (is_number(left) && right.empty()) {
            return {fmt::format("a comma follows the number in {}: values are separated by blanks",
                                shown),
                    std::string(left)};
        }
        return {fmt::format("{} holds a comma: values are separated by blanks, and fractions are "
                            "written with a point",
                            shown),
                {}};
    }
    if (word.find(',') != std::string_view::npos) {
        std::string spaced(word);
        std::replace(spaced.begin(), spaced.end(), ',', ' ');
        return {fmt::format("{} holds commas: values are separated by blanks", shown), spaced};
    }
    const std::size_t prefix = number_prefix(word);
    const std::string_view rest = word.substr(prefix);
    if (prefix > 0 && (rest == "f" || rest == "F")) {
        return {fmt::format("{} ends in an f: numbers have no suffix", shown),
                std::string(word.substr(0, prefix))};
    }
    if (prefix > 0 && rest == ";") {
        return {fmt::format("a semicolon follows the number in {}: values are separated by blanks",
                            shown),
                std::string(word.substr(0, prefix))};
    }
    if (prefix > 0 && (rest == ")" || rest == "]")) {
        return {
            fmt::format("a bracket follows the number in {}: values stand without brackets", shown),
            std::string(word.substr(0, prefix))};
    }
    if (prefix > 0 && rest.starts_with('.') &&
        !contains_letter_of(word,
                            "abcdefghijklmnopqrstuvwxyz"
                            "ABCDEFGHIJKLMNOPQRSTUVWXYZ")) {
        return {fmt::format("{} has more than one decimal point", shown), {}};
    }
    if (prefix > 0 && (rest[0] | 0x20) == 'e' && rest.size() <= 2) {
        return {fmt::format("the exponent of {} has no digits", shown), {}};
    }
    if (prefix > 0) {
        return {fmt::format("{} is no number: {} follows its digits", shown, quoted(rest)), {}};
    }
    return {fmt::format("{} is no number", shown), {}};
}

}  // namespace cobble::frontend
