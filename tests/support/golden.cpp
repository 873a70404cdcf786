// SPDX-License-Identifier: MIT
#include "tests/support/golden.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <vector>

#include "tests/support/disk.hpp"

namespace cobble::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

}  // namespace

void BitsHash::add(std::span<const float> values) {
    for (const float value : values) {
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (int i = 0; i < 4; ++i) {
            state_ = (state_ ^ (bits >> (8 * i) & 255U)) * 0x100000001b3U;
        }
    }
}

std::string BitsHash::text() const {
    std::ostringstream out;
    out << std::hex << std::setw(16) << std::setfill('0') << state_;
    return out.str();
}

void check_golden(std::string_view file, const std::string& now) {
    const std::filesystem::path path = std::filesystem::path(COBBLE_ROOT) / file;
    if (std::getenv("COBBLE_UPDATE") != nullptr) std::ofstream(path, std::ios::binary) << now;
    const std::vector<std::string> ours = lines_of(now);
    const std::vector<std::string> expected = lines_of(file_text(path));
    CAPTURE(file);
    CHECK(ours.size() == expected.size());
    for (std::size_t i = 0; i < ours.size() && i < expected.size(); ++i) {
        CHECK(ours[i] == expected[i]);
    }
}

}  // namespace cobble::test
