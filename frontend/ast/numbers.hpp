// SPDX-License-Identifier: MIT
// Decimal text to double, and what is wrong with words that are nearly numbers.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace cobble::frontend {

enum class NumberRange : unsigned char { kFine, kTooLarge, kTooSmall };

struct ParsedNumber {
    double value = 0;
    NumberRange range = NumberRange::kFine;
};

/// The nearest double of a number token (ties to even); beyond the largest double, or not zero and
/// below the smallest, `range` says so.
ParsedNumber parse_number(std::string_view text);

/// The components of a `#rrggbb` token, each a 255th.
std::array<double, 3> parse_color(std::string_view text);

struct MalformedNumber {
    std::string message;      ///< one sentence
    std::string replacement;  ///< what was evidently meant, or empty
};

/// Why a word that looks like a number is none.
MalformedNumber explain_malformed(std::string_view word);

}  // namespace cobble::frontend
