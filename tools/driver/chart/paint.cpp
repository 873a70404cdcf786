// SPDX-License-Identifier: MIT
#include "tools/driver/chart/paint.hpp"

#include <fmt/core.h>

#include <cstddef>

namespace cobble::driver::chart {
namespace {

struct Row {
    std::string_view name;
    std::string_view light;
    std::string_view dark;
};

// In the order of Paint. The dark ones are as far from the dark paper as the light ones from white.
constexpr Row kRows[] = {
    {"paper", "#ffffff", "#15171c"},     {"ink", "#1a1a1a", "#e8e6e3"},
    {"soft", "#555555", "#b3b1ad"},      {"grid", "#d0d0d0", "#454a54"},
    {"faint", "#ececec", "#282c34"},     {"blue", "#0072b2", "#56b4e9"},
    {"vermilion", "#d55e00", "#ff9248"}, {"grey", "#767676", "#9a9a9a"},
};
static_assert(std::size(kRows) == static_cast<std::size_t>(Paint::kCount_));

}  // namespace

std::string_view color_of(Paint paint) { return kRows[static_cast<std::size_t>(paint)].light; }

std::string_view name_of(Paint paint) { return kRows[static_cast<std::size_t>(paint)].name; }

std::string dark_rules(std::string_view selector, std::string_view indent) {
    std::string css;
    for (const Row& row : kRows) {
        css += fmt::format(
            "{0}{1} .fill-{2} {{ fill: {3} }}\n"
            "{0}{1} .stroke-{2} {{ stroke: {3} }}\n",
            indent, selector, row.name, row.dark);
    }
    return css;
}

}  // namespace cobble::driver::chart
