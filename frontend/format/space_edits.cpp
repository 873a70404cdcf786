// SPDX-License-Identifier: MIT
#include "frontend/format/space_edits.hpp"

#include <algorithm>

namespace cobble::frontend {
namespace {

/// What the lexer takes for white space.
constexpr std::string_view kSpace = " \t\r\n\f\v";

std::size_t end_of_space(std::string_view text, std::size_t at) {
    return std::min(text.find_first_not_of(kSpace, at), text.size());
}

}  // namespace

std::vector<SpaceEdit> space_edits(std::string_view before, std::string_view after) {
    std::vector<SpaceEdit> edits;
    std::size_t i = 0;
    std::size_t k = 0;
    while (true) {
        const std::size_t space_i = end_of_space(before, i);
        const std::size_t space_k = end_of_space(after, k);
        const std::string_view space = after.substr(k, space_k - k);
        if (before.substr(i, space_i - i) != space) {
            edits.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(space_i),
                             std::string(space)});
        }
        i = space_i;
        k = space_k;
        if (i == before.size() && k == after.size()) return edits;
        if (i == before.size() || k == after.size() || before[i] != after[k]) {
            return {{0, static_cast<std::uint32_t>(before.size()), std::string(after)}};
        }
        // Up to the next white space of either: there may be none in the one where words touch.
        ++i;
        ++k;
    }
}

}  // namespace cobble::frontend
