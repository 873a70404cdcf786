// SPDX-License-Identifier: MIT
#include "tests/support/record.hpp"

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace cobble::test {

void record(int row, const std::string& text) {
    const char* file = std::getenv("COBBLE_HARD_RESULTS");
    if (file == nullptr) return;
    std::ofstream(file, std::ios::app) << row << '\t' << text << '\n';
}

std::string counted(std::int64_t n) {
    std::string digits = std::to_string(n < 0 ? -n : n);
    for (auto at = static_cast<std::int64_t>(digits.size()) - 3; at > 0; at -= 3) {
        digits.insert(static_cast<std::size_t>(at), ",");
    }
    return n < 0 ? "-" + digits : digits;
}

std::string brief(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", x);
    return text;
}

}  // namespace cobble::test
