// SPDX-License-Identifier: MIT
// A program outside the repository that uses the installed package.
#include <fmt/core.h>

#include <string_view>

#include "frontend/source/line_index.hpp"
#include "grammar/vocabulary.hpp"

int main() {
    constexpr std::string_view kText = "Group {\n    Sphere\n";
    const auto place = cobble::source::LineIndex(kText).locate(12);
    const auto* block = cobble::grammar::find_block("Sphere");
    fmt::print("{}:{} {}\n", place.line, place.column, block != nullptr ? block->name : "?");
    return 0;
}
