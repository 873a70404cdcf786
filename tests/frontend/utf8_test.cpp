// SPDX-License-Identifier: MIT
#include "frontend/source/utf8.hpp"

#include <doctest/doctest.h>

#include <string>

#include "frontend/check/check.hpp"

using namespace cobble;

TEST_CASE("what is not text is told with its place") {
    CHECK(source::why_not_text("").empty());
    CHECK(source::why_not_text("Group {}\n").empty());
    CHECK(source::why_not_text("\xEF\xBB\xBF// gr\xC3\xBC\xC3\x9F\n").empty());
    CHECK(source::why_not_text("abc\xFF") == "invalid UTF-8 at offset 3");
    CHECK(source::why_not_text("\xC3\xBC\xC3") == "invalid UTF-8 at offset 2");
    CHECK(source::why_not_text(std::string("ab\0\xFF", 4)) == "zero byte at offset 2");
    CHECK(source::why_not_text(std::string("a\xFF\0", 3)) == "invalid UTF-8 at offset 1");
    CHECK(source::why_not_text(std::string("\xFF\xFE"
                                           "G\0",
                                           4)) == "it is UTF-16, not UTF-8");
}

TEST_CASE("binary files are told by their first 8 KiB") {
    CHECK(source::looks_binary(std::string(1, '\0')));
    CHECK(source::looks_binary("\xFE\xFF"));
    CHECK(source::looks_binary(std::string(8191, ' ') + '\0'));
    CHECK_FALSE(source::looks_binary(std::string(8192, ' ') + '\0'));
    CHECK_FALSE(source::looks_binary("caf\xE9"));
    CHECK_FALSE(source::looks_binary(""));
}

TEST_CASE("of a binary file nothing is said but that") {
    std::string text = "} } } {";
    text += '\0';
    for (int i = 0; i < 1000; ++i) text += "\xFF } x\n";
    const auto scene = frontend::check(source::SourceId{0}, text);
    REQUIRE(scene.diagnostics.size() == 1);
    CHECK(scene.diagnostics[0].code->code == "not-text");
    CHECK(scene.diagnostics[0].message == "the file is not text: it holds zero bytes");
    CHECK_FALSE(scene.diagnostics[0].span.valid());
}
