// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "frontend/source/line_index.hpp"
#include "frontend/source/utf8.hpp"

using namespace cobble::source;

namespace {

struct Place {
    std::uint32_t offset;
    LineColumn bytes;
    LineColumn code_points;
    LineColumn utf16;
};

// What the index should say, by walking over the text from its beginning.
std::vector<Place> walk(std::string_view text) {
    std::vector<Place> places;
    std::uint32_t line = 1;
    std::uint32_t columns[3] = {1, 1, 1};
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    while (true) {
        places.push_back({static_cast<std::uint32_t>(at),
                          {line, columns[0]},
                          {line, columns[1]},
                          {line, columns[2]}});
        if (at == text.size()) return places;
        const char byte = text[at];
        const std::size_t known = utf8_length(text.substr(at));
        const std::size_t length = known == 0 ? 1 : known;
        at += length;
        const bool crlf = byte == '\r' && at < text.size() && text[at] == '\n';
        if (byte == '\n' || (byte == '\r' && !crlf)) {
            ++line;
            columns[0] = columns[1] = columns[2] = 1;
        } else {
            columns[0] += static_cast<std::uint32_t>(length);
            columns[1] += 1;
            columns[2] += length == 4 ? 2 : 1;
        }
    }
}

void check_all(std::string_view text) {
    const LineIndex index(text);
    for (const Place& place : walk(text)) {
        CAPTURE(place.offset);
        CHECK(index.locate(place.offset, ColumnUnit::kByte) == place.bytes);
        CHECK(index.locate(place.offset, ColumnUnit::kCodePoint) == place.code_points);
        CHECK(index.locate(place.offset, ColumnUnit::kUtf16) == place.utf16);
        // Back again; between CR and LF is past the line's end, which is before the CR.
        const bool in_crlf = place.offset > 0 && place.offset < text.size() &&
                             text[place.offset] == '\n' && text[place.offset - 1] == '\r';
        const std::uint32_t back = place.offset - (in_crlf ? 1 : 0);
        CHECK(index.offset(place.bytes, ColumnUnit::kByte) == back);
        CHECK(index.offset(place.code_points, ColumnUnit::kCodePoint) == back);
        CHECK(index.offset(place.utf16, ColumnUnit::kUtf16) == back);
    }
}

// U+00E9 in two bytes, U+2192 in three, U+1D11E in four (two units of UTF-16).
constexpr std::string_view kMixed = "a\xC3\xA9z \xE2\x86\x92| \xF0\x9D\x84\x9E!";

}  // namespace

TEST_CASE("lines end at LF, CRLF and lone CR") {
    const std::string_view text = "one\ntwo\r\nthree\rfour\n\r\n\rlast";
    const LineIndex index(text);
    CHECK(index.line_count() == 7);
    CHECK(index.line_text(1) == "one");
    CHECK(index.line_text(2) == "two");
    CHECK(index.line_text(3) == "three");
    CHECK(index.line_text(4) == "four");
    CHECK(index.line_text(5).empty());
    CHECK(index.line_text(6).empty());
    CHECK(index.line_text(7) == "last");
    CHECK(index.line_text(0).empty());
    CHECK(index.line_text(8).empty());
    CHECK(index.locate(4) == LineColumn{2, 1});
    CHECK(index.locate(15) == LineColumn{4, 1});
}

TEST_CASE("places match a walk over the text, in every unit") {
    for (const std::string_view text :
         {std::string_view(""), std::string_view("\n"), std::string_view("a"),
          std::string_view("\tx\t\ty"), std::string_view("one\ntwo\r\nthree\rfour"), kMixed,
          std::string_view("\xEF\xBB\xBF"),
          std::string_view("\xEF\xBB\xBF"
                           "a\nb"),
          std::string_view("\xEF\xBB\xBF\xC3\xA9 b\r\n\xF0\x9D\x84\x9E c"),
          std::string_view("bad \xFF\xFE\xC3( \xE2\x86 \xF0\x9D\x84 \xED\xA0\x80 end"),
          std::string_view("nul \0 byte\n\0", 12)}) {
        CAPTURE(text);
        check_all(text);
    }
}

TEST_CASE("places match beyond the first counts of a long text") {
    std::string text;
    while (text.size() < 20000) text += kMixed;
    check_all(text);
    text += "\r\n" + text;
    check_all(text);
}

TEST_CASE("a byte-order mark is no column") {
    const LineIndex index(
        "\xEF\xBB\xBF"
        "Group");
    for (const std::uint32_t offset : {0U, 1U, 2U, 3U}) {
        CHECK(index.locate(offset) == LineColumn{1, 1});
    }
    CHECK(index.locate(4) == LineColumn{1, 2});
    CHECK(index.offset({1, 1}) == 3);
}

TEST_CASE("what lies outside is clamped") {
    const LineIndex index("ab\ncd");
    CHECK(index.locate(99) == LineColumn{2, 3});
    CHECK(index.offset({1, 99}) == 2);
    CHECK(index.offset({99, 1}) == 5);
    CHECK(index.offset({0, 5}) == 0);
    CHECK(index.offset({2, 0}) == 3);
}

TEST_CASE("an offset inside a character belongs to the character") {
    const LineIndex index(kMixed);
    CHECK(index.locate(2) == index.locate(1));
    const auto note = static_cast<std::uint32_t>(kMixed.find('\xF0'));
    for (std::uint32_t i = 1; i < 4; ++i) CHECK(index.locate(note + i) == index.locate(note));
    // The second half of a UTF-16 pair is no place of its own.
    const LineColumn begin = index.locate(note, ColumnUnit::kUtf16);
    CHECK(index.offset({begin.line, begin.column + 1}, ColumnUnit::kUtf16) == note + 4);
}

TEST_CASE("a very long line costs no more than a short one") {
    // 16 MB on one line: looking each of these places up by reading the line would take minutes.
    std::string text;
    for (int i = 0; i < (1 << 20); ++i) text += "\xF0\x9D\x84\x9E 123456 \xC3\xA9";
    const LineIndex index(text);
    std::uint32_t last = 0;
    for (std::uint32_t offset = 0; offset < text.size(); offset += 160) {
        const LineColumn place = index.locate(offset);
        CHECK(place.column > last);
        last = place.column;
    }
    // Ten characters a piece.
    CHECK(index.locate(static_cast<std::uint32_t>(text.size())).column == 10U * (1U << 20U) + 1);
}

TEST_CASE("well-formed UTF-8 is as Unicode's table 3-7 says") {
    CHECK(utf8_length("") == 0);
    CHECK(utf8_length("a") == 1);
    CHECK(utf8_length("\xC2\x80") == 2);
    CHECK(utf8_length("\xE0\xA0\x80") == 3);
    CHECK(utf8_length("\xEE\x80\x80") == 3);
    CHECK(utf8_length("\xF0\x90\x80\x80") == 4);
    CHECK(utf8_length("\xF4\x8F\xBF\xBF") == 4);
    for (const std::string_view bad :
         {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xC2", "\xC2 ", "\xE0\x9F\xBF", "\xE0\xA0",
          "\xED\xA0\x80", "\xED\xBF\xBF", "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80",
          "\xF5\x80\x80\x80", "\xF0\x90\x80", "\xFF"}) {
        CAPTURE(bad);
        CHECK(utf8_length(bad) == 0);
    }
}
