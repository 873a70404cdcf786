// SPDX-License-Identifier: MIT
// Numbers written in text, as options and files of ours hold them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace cobble::driver {

/// All of `text` as one number in decimal; false if it is not that, or does not fit, or (double) is
/// not finite.
bool parse_number(std::string_view text, std::uint32_t& number);
bool parse_number(std::string_view text, std::uint64_t& number);
bool parse_number(std::string_view text, double& number);

/// All of `text` as numbers with `separator` between them, exactly `count`; false if it is not
/// that, or one of them is no number.
bool parse_numbers(std::string_view text, char separator, std::size_t count,
                   std::vector<std::uint32_t>& numbers);
bool parse_numbers(std::string_view text, char separator, std::size_t count,
                   std::vector<double>& numbers);

}  // namespace cobble::driver
