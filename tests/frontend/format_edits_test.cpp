// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <string>

#include "frontend/format/edits.hpp"

namespace cobble::frontend {
namespace {

std::size_t lines_touched(const std::vector<LineEdit>& edits) {
    std::size_t lines = 0;
    for (const LineEdit& edit : edits) lines += edit.old_count + edit.new_count;
    return lines;
}

void check(const std::string& before, const std::string& after, std::size_t edit_count,
           std::size_t touched) {
    CAPTURE(before);
    CAPTURE(after);
    const auto edits = line_edits(before, after);
    CHECK(apply(before, after, edits) == after);
    CHECK(edits.size() == edit_count);
    CHECK(lines_touched(edits) == touched);
}

TEST_CASE("only lines that change are touched") {
    check("", "", 0, 0);
    check("a\nb\n", "a\nb\n", 0, 0);
    check("a\n  b\nc\n", "a\n    b\nc\n", 1, 2);
    check("a\n\n\n\nb\n", "a\n\nb\n", 1, 2);
    check("a\nb\n", "a\n\nb\n", 1, 1);
    check("a { b 1 c 2 }\nd\n", "a {\n    b 1\n    c 2\n}\nd\n", 1, 5);
    check("a\nx 1\n2\nb\n", "a\nx 1 2\nb\n", 1, 3);
    check("a", "a\n", 1, 2);
    check("\n\na\n", "a\n", 1, 2);
    check("a\nb\nc\nd\n", " a\nb\n c\nd\n", 2, 4);
    check("a\r\nb\r\n", "a\r\nb\n", 1, 2);
    check("a\rb\rc", "a\r b\rc", 1, 2);
}

TEST_CASE("texts that differ in more than white space still give a right edit") {
    check("a\nb\nc\n", "a\nx\nc\n", 1, 2);
    check("a\nb\n", "", 1, 2);
    check("", "a\n", 1, 1);
    check("a\na\na\n", "a\na\n", 1, 1);
}

}  // namespace
}  // namespace cobble::frontend
