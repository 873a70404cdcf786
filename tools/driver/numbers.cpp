// SPDX-License-Identifier: MIT
#include "tools/driver/numbers.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>

namespace cobble::driver {
namespace {

template <std::unsigned_integral Number>
bool parse_whole(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size();
}

template <typename Number>
bool parse_all(std::string_view text, char separator, std::size_t count,
               std::vector<Number>& numbers) {
    numbers.clear();
    for (;;) {
        const std::size_t end = std::min(text.find(separator), text.size());
        Number number{};
        if (!parse_number(text.substr(0, end), number)) return false;
        numbers.push_back(number);
        if (end == text.size()) break;
        text.remove_prefix(end + 1);
    }
    return numbers.size() == count;
}

}  // namespace

bool parse_number(std::string_view text, std::uint32_t& number) {
    return parse_whole(text, number);
}

bool parse_number(std::string_view text, std::uint64_t& number) {
    return parse_whole(text, number);
}

bool parse_number(std::string_view text, double& number) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] =
        fast_float::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

bool parse_numbers(std::string_view text, char separator, std::size_t count,
                   std::vector<std::uint32_t>& numbers) {
    return parse_all(text, separator, count, numbers);
}

bool parse_numbers(std::string_view text, char separator, std::size_t count,
                   std::vector<double>& numbers) {
    return parse_all(text, separator, count, numbers);
}

}  // namespace cobble::driver
