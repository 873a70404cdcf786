// SPDX-License-Identifier: MIT
// The difference between two texts as `diff -u` writes it, so that `patch` can apply it.
#pragma once

#include <string>
#include <string_view>

namespace cobble::driver {

struct DiffStyle {
    bool color = false;
    unsigned context = 3;  ///< unchanged lines around each change
};

/// "" for equal texts. Names are written so that `patch` takes them, whatever they hold. Lines are
/// compared byte for byte and end at LF. The result is correct but not always the shortest: where
/// two stretches differ in more than a few hundred places, and have no line in common that occurs
/// once in each, they are shown as replaced whole. This keeps the cost near linear.
std::string unified_diff(std::string_view before, std::string_view after,
                         std::string_view before_name, std::string_view after_name,
                         const DiffStyle& style = {});

}  // namespace cobble::driver
