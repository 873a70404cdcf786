// SPDX-License-Identifier: MIT
// One brace too few or too many in a good file is one error, wherever and however it is indented.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/check/verify_fixes.hpp"
#include "tests/frontend/case_text.hpp"

using namespace cobble;
using namespace cobble::frontend;

namespace {

constexpr source::SourceId kSource{0};

std::vector<std::string> good_texts() {
    std::vector<std::string> texts;
    for (const std::string& path : test::files_in(COBBLE_ROOT "/scenes", ".scene")) {
        std::string text = test::read_file(path);
        // Larger files only repeat what smaller ones have, in quadratic time.
        if (text.size() < 6000) texts.push_back(std::move(text));
    }
    return texts;
}

std::size_t errors_in(const std::string& text, std::string_view code) {
    const CheckedScene scene = check_unverified(kSource, text);
    const auto errors = std::ranges::count_if(scene.diagnostics, [](const auto& diagnostic) {
        return diagnostic.severity == source::Severity::kError;
    });
    const bool found = std::ranges::any_of(scene.diagnostics, [code](const auto& diagnostic) {
        return diagnostic.code->code == code;
    });
    return found ? static_cast<std::size_t>(errors) : 0;
}

// Calls `change(text, offset)` for every brace of this kind in every good file; the changed text
// must have one error, with this code.
template <typename Change>
void expect_one_error(TokenKind brace, std::string_view code, Change change) {
    for (const std::string& text : good_texts()) {
        const Tokens tokens = lex(text);
        for (std::uint32_t i = 0; i < tokens.size(); ++i) {
            if (tokens.kind({i}) != brace) continue;
            std::string changed = text;
            change(changed, tokens.range({i}).begin);
            CAPTURE(changed);
            CAPTURE(test::describe(changed, check_unverified(kSource, changed).diagnostics));
            CHECK(errors_in(changed, code) == 1);
        }
    }
}

std::string codes_of(const std::string& text) {
    const Tokens tokens = lex(text);
    std::string codes;
    for (const auto& diagnostic : bind(kSource, tokens, parse(tokens)).diagnostics) {
        codes +=
            std::string(diagnostic.code->code) + "@" + std::to_string(diagnostic.span.begin) + " ";
    }
    return codes;
}

}  // namespace

TEST_CASE("every deleted opening brace is one error") {
    expect_one_error(TokenKind::kOpenBrace, "missing-brace",
                     [](std::string& text, std::size_t at) { text.erase(at, 1); });
}

TEST_CASE("every doubled opening brace is one error") {
    expect_one_error(TokenKind::kOpenBrace, "nameless-block",
                     [](std::string& text, std::size_t at) { text.insert(at, "{ "); });
}

TEST_CASE("every doubled closing brace is one error, on its line or below") {
    expect_one_error(TokenKind::kCloseBrace, "extra-brace",
                     [](std::string& text, std::size_t at) { text.insert(at + 1, " }"); });
    expect_one_error(TokenKind::kCloseBrace, "extra-brace", [](std::string& text, std::size_t at) {
        const std::size_t line = text.rfind('\n', at) + 1;
        const std::string indent = text.substr(line, text.find_first_not_of(' ', line) - line);
        text.insert(at + 1, "\n" + indent + "}");
    });
}

TEST_CASE("without any indentation a deleted brace is still no cascade") {
    for (const std::string& indented : good_texts()) {
        std::string text;
        for (std::size_t i = 0; i < indented.size(); ++i) {
            const bool leading = indented[i] == ' ' && (text.empty() || text.back() == '\n');
            if (!leading) text += indented[i];
        }
        const Tokens tokens = lex(text);
        for (std::uint32_t i = 0; i < tokens.size(); ++i) {
            if (tokens.kind({i}) != TokenKind::kCloseBrace) continue;
            std::string broken = text;
            broken.erase(tokens.range({i}).begin, 1);
            CAPTURE(broken);
            const std::size_t errors = errors_in(broken, "missing-brace");
            CHECK(errors >= 1);
            CHECK(errors <= 2);
        }
    }
}

TEST_CASE("a block indented as a member is misplaced, one beside its neighbour ends it") {
    CHECK(codes_of("Lights {\n    Background {\n    }\n    PointLight {\n    }\n}\n") ==
          "misplaced-block@13 ");
    CHECK(codes_of("Lights {\nBackground {\n}\n") == "missing-brace@8 ");
    CHECK(codes_of("Lights { PointLight { color 1 1 1 PointLight { color 1 1 1 } }") ==
          "missing-brace@33 ");
    CHECK(codes_of("Materials { Group { } Group { }") == "missing-brace@11 ");
    CHECK(codes_of("Group { Sphere { center 0 0 0 radius 1 Sphere { center 0 0 0 radius 1 } }") ==
          "missing-brace@38 ");
    CHECK(codes_of("Lights { Noise { octaves 2 } }") == "misplaced-block@9 ");
    CHECK(
        codes_of("Materials { Material {\n    Noise {\n        octaves 1\n    shininess 3\n} }") ==
        "missing-brace@52 ");
}

TEST_CASE("what was meant as one thing is one error") {
    CHECK(codes_of("Group { Transform { Rotate 0 1 0 90 Sphere { } } }") == "missing-brace@26 ");
    CHECK(codes_of("Group { Transform {\n    Rotate 0 1 0 90\n} }") == "missing-brace@30 ");
    // Where the braces of the file add up, the } after the numbers is not theirs ...
    CHECK(codes_of("Group { Transform { Sphere { } Rotate 0 1 0 90 } }") == "missing-brace@37 ");
    CHECK(codes_of("Group { Transform {\n Sphere { }\n Rotate 0 1 0 90\n } }") ==
          "missing-brace@39 ");
    // ... and where one is too many, it is.
    CHECK(codes_of("Group { Transform { Sphere { } Rotate 0 1 0 90 } } }") == "missing-brace@37 ");
    CHECK(codes_of("Group { Transform { Scale { 1 1 1 } Sphere { } } }") ==
          "unexpected-braces@20 ");
    CHECK(codes_of("Group { { center 0 0 0 radius 1 } }") == "nameless-block@8 ");
    CHECK(codes_of("Group { Sphere {{ center 0 0 0 radius 1 } }") == "nameless-block@16 ");
    CHECK(codes_of("Group { Sphere lamp center 0 0 0 radius 1 } }") == "missing-brace@19 ");
    CHECK(codes_of("Group { Sphere\nlamp { center 0 0 0 radius 1 } }") == "bad-label@15 ");
    CHECK(codes_of("Group { MaterialIndex stone\n{ center 0 0 0 } }") == "nameless-block@28 ");
    CHECK(codes_of("Group { center { 0 0 0 } }") == "unknown-name@8 ");
    // A name without braces has no } that could be one too many, whatever its last value is.
    CHECK(codes_of("Lights {\n  Sphere 1 2\n      3\n}\n}\n}") ==
          "misplaced-block@11 extra-brace@32 extra-brace@34 ");
    CHECK(codes_of("# a remark in words\nGroup { }") == "unknown-name@0 ");
}
