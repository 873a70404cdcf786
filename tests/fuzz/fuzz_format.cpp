// SPDX-License-Identifier: MIT
// The formatter on any text, whole and by lines: it never refuses, moves white space only, and has
// nothing to add the second time.
#include <cstdint>
#include <string>
#include <string_view>

#include "frontend/format/format.hpp"
#include "tests/fuzz/expect.hpp"

namespace {

/// Longer inputs reach nothing that shorter ones do not, and take time.
constexpr std::size_t kLargestInput = 4096;

std::string without_white_space(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (std::string_view(" \t\r\n\v\f").find(c) == std::string_view::npos) result += c;
    }
    return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cobble;
    using fuzz::expect;
    if (size > kLargestInput) return -1;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const frontend::FormatResult result = frontend::format(text);
    expect(!result.refused, "the proof holds");
    expect(!result.left_alone || (result.has_errors && result.text == text),
           "only broken files are left alone");
    expect(without_white_space(text) == without_white_space(result.text),
           "only white space changes");
    const frontend::FormatResult again = frontend::format(result.text);
    expect(again.text == result.text, "twice is once");

    // Some lines in the middle.
    const auto first = static_cast<std::uint32_t>(size % 7 + 1);
    const frontend::FormatResult part = frontend::format(text, {first, first + 3});
    expect(!part.refused, "the proof holds for a range");
    expect(without_white_space(text) == without_white_space(part.text),
           "only white space changes in a range");
    return 0;
}
