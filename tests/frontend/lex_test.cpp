// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/lex/tokens.hpp"
#include "frontend/lex/words.hpp"

using namespace cobble::frontend;

namespace {

// One letter a token: what the table below compares.
std::string kinds(std::string_view text) {
    static constexpr std::string_view kLetters = "{}ncwsue";
    const Tokens tokens = lex(text);
    std::string result;
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        result += kLetters[static_cast<std::size_t>(tokens.kind({i}))];
    }
    for (std::size_t i = 0; i < tokens.comments.size(); ++i) result += '/';
    return result;
}

std::string join(std::initializer_list<std::string_view> parts) {
    std::string result;
    for (const std::string_view part : parts) result.append(part);
    return result;
}

std::string comment_of(std::string_view text) {
    const Tokens tokens = lex(text);
    REQUIRE(tokens.comments.size() == 1);
    const ByteRange range = tokens.comments[0];
    return std::string(text.substr(range.begin, range.end - range.begin));
}

}  // namespace

TEST_CASE("chunks are classified whole") {
    struct Case {
        std::string_view text;
        std::string_view kinds;  ///< n number, c colour, w word, s string, u unterminated, e end
    };
    const Case cases[] = {
        {"", "e"},           {" \t\r\n\v\f", "e"}, {"5", "ne"},
        {"5.", "ne"},        {".5", "ne"},         {"-.5", "ne"},
        {"+1", "ne"},        {"1e-3", "ne"},       {"1E+3", "ne"},
        {"5.e2", "ne"},      {".", "we"},          {"-", "we"},
        {"+.", "we"},        {"--1", "we"},        {"1e", "we"},
        {"1e+", "we"},       {"e5", "we"},         {"1.2.3", "we"},
        {"0.5f", "we"},      {"1,2", "we"},        {"0x1p3", "we"},
        {"inf", "we"},       {"nan", "we"},        {"007.bmp", "we"},
        {"../a.bmp", "we"},  {"inf.obj", "we"},    {"20color", "we"},
        {"#a0B1c2", "ce"},   {"#a0b1c", "we"},     {"#a0b1c22", "we"},
        {"#a0b1cg", "we"},   {"#", "we"},          {"20}", "n}e"},
        {"Lights{", "w{e"},  {"}{", "}{e"},        {"{center", "{we"},
        {"a}b{c", "w}w{we"}, {"#a0b1c2}", "c}e"},  {"\"two words\"", "se"},
        {"\"\"", "se"},      {"\"{ // }\"", "se"}, {"\"open", "ue"},
        {"\"", "ue"},        {"\"open\n}", "u}e"}, {"\"open\r}", "u}e"},
        {"a\"b\"c", "wswe"}, {"5\"x\"", "nse"},    {"\"a\\\"b\"", "swue"},
        {"1\v2\f3", "nnne"}, {"a;b", "we"},        {"/", "we"},
        {"a/b", "we"},
    };
    for (const Case& one : cases) {
        CAPTURE(one.text);
        CHECK(kinds(one.text) == one.kinds);
    }
    CHECK(kinds(std::string_view("a\0b 5\0", 6)) == "wwe");
    CHECK(kinds("\xEF\xBB\xBF"
                "5") == "ne");
    CHECK(kinds("5 \xEF\xBB\xBF") == "nwe");
}

TEST_CASE("comments begin at the start of a chunk or right behind a number or colour") {
    CHECK(kinds("// c") == "e/");
    CHECK(kinds("//") == "e/");
    CHECK(kinds("20//c") == "ne/");
    CHECK(kinds("20 //c") == "ne/");
    CHECK(kinds("#a0b1c2//c") == "ce/");
    CHECK(kinds("tex//a.bmp") == "we");
    CHECK(kinds("1.2.3//c") == "we");
    CHECK(kinds("20/c") == "we");
    CHECK(kinds("{//c") == "{e/");
    CHECK(kinds("}//c\n}") == "}}e/");
    CHECK(kinds("\"a\"//c") == "se/");
    CHECK(kinds("///") == "e/");
    CHECK(kinds("a // b // c\nd") == "wwe/");
    CHECK(kinds("// a\r// b\r\n// c\n") == "e///");
    CHECK(comment_of("5 // to the end \t\r\n6") == "// to the end \t");
    CHECK(comment_of("//a\rb") == "//a");
    CHECK(comment_of("//a\vb") == "//a\vb");
    CHECK(comment_of("//\"{}") == "//\"{}");
}

TEST_CASE("words and strings give their text") {
    const Tokens tokens = lex("brick.bmp \"two words.bmp\" \"\" \"open");
    CHECK(tokens.word_of({0}) == "brick.bmp");
    CHECK(tokens.text_of({1}) == "\"two words.bmp\"");
    CHECK(tokens.word_of({1}) == "two words.bmp");
    CHECK(tokens.word_of({2}).empty());
    CHECK(tokens.word_of({3}) == "open");
}

TEST_CASE("lines are told by every kind of line end") {
    const Tokens tokens =
        lex("\xEF\xBB\xBF"
            "a b\n  c\rd // x\r\n\te // y\nf");
    const bool first[] = {true, false, true, true, true, true};
    const bool ends[] = {false, true, true, true, true, false};
    for (std::uint32_t i = 0; i < 6; ++i) {
        CAPTURE(i);
        CHECK(tokens.first_on_line({i}) == first[i]);
        CHECK(tokens.line_ends_after({i}) == ends[i]);
    }
    CHECK(!tokens.line_ends_after({6}));
    CHECK(lex("  a").first_on_line({0}));
    CHECK(!lex("//c\na").line_ends_after({0}));
    CHECK(lex("//c\na").first_on_line({0}));
}

TEST_CASE("bytes that are no UTF-8 are listed") {
    using Offsets = std::vector<std::uint32_t>;
    CHECK(lex("caf\xC3\xA9").invalid_utf8 == Offsets{});
    CHECK(lex("caf\xE9 x").invalid_utf8 == Offsets{3});
    CHECK(lex("\xFF\xFE").invalid_utf8 == Offsets{0, 1});
    CHECK(lex("// \xE2\x86").invalid_utf8 == Offsets{3, 4});
    CHECK(lex("\"\xED\xA0\x80\"").invalid_utf8 == Offsets{1, 2, 3});
    CHECK(lex("\xEF\xBB\xBF"
              "a")
              .invalid_utf8 == Offsets{});
}

TEST_CASE("tokens too long for their length field keep their end") {
    const std::string digits(kLongToken, '7');
    const std::string more = join({digits, "77"});
    const struct {
        std::string text;
        TokenKind kind;
        std::size_t length;
    } cases[] = {
        {join({digits.substr(1), " 1"}), TokenKind::kNumber, kLongToken - 1},
        {join({digits, " 1"}), TokenKind::kNumber, kLongToken},
        {join({more, "//c"}), TokenKind::kNumber, kLongToken + 2},
        {join({more, "}"}), TokenKind::kNumber, kLongToken + 2},
        {join({"x//", more, " 1"}), TokenKind::kWord, kLongToken + 5},
        {join({"\"", digits.substr(2), "\" 1"}), TokenKind::kString, kLongToken},
        {join({"\"", more, "\" 1"}), TokenKind::kString, kLongToken + 4},
        {join({"\"", more, "\n 1"}), TokenKind::kUnterminatedString, kLongToken + 3},
        {join({"\"", more}), TokenKind::kUnterminatedString, kLongToken + 3},
        {more, TokenKind::kNumber, kLongToken + 2},
    };
    for (const auto& one : cases) {
        const Tokens tokens = lex(one.text);
        CHECK(tokens.kind({0}) == one.kind);
        CHECK(tokens.text_of({0}).size() == one.length);
    }
}

TEST_CASE("words that were meant as numbers, and labels") {
    for (const std::string_view word :
         {"1.2.3", "0.5f", "1,2", "0x1p3", "inf", "-INF", "NaN", "+nan", "infinity", "--1", ".5f",
          ",5", "-.5.", "1e", "007.bmp", "+-3"}) {
        CAPTURE(word);
        CHECK(looks_like_number(word));
    }
    for (const std::string_view word :
         {"", "-", ".", "a1", "info", "inf.obj", "-x", "nano", ".e"}) {
        CAPTURE(word);
        CHECK(!looks_like_number(word));
    }
    for (const std::string_view word : {"a", "_", "Stone-2", "a_b"}) CHECK(is_label(word));
    for (const std::string_view word : {"", "1a", "-a", "a.b", "\"a\"", "a/b", "\xC3\xA9"}) {
        CHECK(!is_label(word));
    }
}
