// SPDX-License-Identifier: MIT
// Sizes that nobody writes, but that must neither crash nor go quadratic: each of these takes a
// fraction of a second, and would take hours if it did.
#include <doctest/doctest.h>

#include <initializer_list>
#include <string>

#include "frontend/ast/ast.hpp"
#include "frontend/check/check.hpp"
#include "frontend/format/format.hpp"
#include "frontend/parse/cst.hpp"
#include "tests/frontend/tree_invariants.hpp"

using namespace cobble;
using namespace cobble::frontend;

namespace {

constexpr std::size_t kMillion = 1000000;
constexpr source::SourceId kSource{0};

std::string repeated(std::string_view piece, std::size_t count) {
    std::string text;
    text.reserve(piece.size() * count);
    for (std::size_t i = 0; i < count; ++i) text += piece;
    return text;
}

BoundAst check_text(const std::string& text) {
    const Tokens tokens = lex(text);
    const Cst cst = parse(tokens);
    CHECK(test::tree_fault(tokens, cst) == "");
    return bind(kSource, tokens, cst);
}

}  // namespace

TEST_CASE("a million nested blocks") {
    const BoundAst bound = check_text(repeated("Group { ", kMillion) + repeated("} ", kMillion));
    CHECK(bound.diagnostics.empty());
    CHECK(bound.ast.blocks.size() == kMillion);
    CHECK(bound.ast.roots.size() == 1);
}

TEST_CASE("a million nested blocks are checked and formatted") {
    const std::string text = repeated("Group { ", kMillion) + repeated("} ", kMillion);
    const CheckedScene scene = check(kSource, text);
    REQUIRE(scene.diagnostics.size() > 1);
    CHECK(scene.diagnostics[0].code->code == "empty-group");
    CHECK(scene.diagnostics[1].code->code == "missing-section");
    const FormatResult formatted = format(text);
    CHECK(!formatted.refused);
    // A line for each brace, indented by no more than 20 levels of four: deeper ones would make a
    // text of a million million bytes.
    CHECK(formatted.text.size() < 2 * kMillion * (20 * 4 + sizeof("Group {\n")));
}

TEST_CASE("a million nested blocks that are wrong in every way") {
    const std::string groups = repeated("Group { Transform {\n", kMillion / 2);
    const struct {
        std::string text;
        std::string_view code;
    } cases[] = {
        {repeated("Group {\n", kMillion), "missing-brace"},
        {repeated("{ ", kMillion), "nameless-block"},
        {repeated("} ", kMillion), "extra-brace"},
        {repeated("Unknown { } ", kMillion), "unknown-name"},
        {repeated("Unknown { ", kMillion), "missing-brace"},
        {repeated("Sphere ", kMillion), "misplaced-block"},
        {repeated("Group ", kMillion), "missing-brace"},
        {repeated("Lights { PointLight { ", kMillion), "missing-brace"},
        {repeated("Materials {\n PhongMaterial {\n  Noise {\n }\n", kMillion / 4), "missing-brace"},
        // Each close lays one more Transform open to a name that may not stand in it, with all that
        // is nested in it to look through.
        {groups + repeated("MaterialIndex 0 } ", kMillion / 2), "missing-brace"},
        {groups + repeated("Noise { } ", kMillion / 2) + repeated("} ", kMillion),
         "misplaced-block"},
        {repeated("Transform {\n    Sphere {\n    } }\n}\n", kMillion / 4), "extra-brace"},
    };
    for (const auto& one : cases) {
        CAPTURE(one.text.substr(0, 40));
        const BoundAst bound = check_text(one.text);
        bool found = false;
        for (const auto& diagnostic : bound.diagnostics) found |= diagnostic.code->code == one.code;
        CHECK(found);
        CHECK(bound.diagnostics.size() <= 10001);
    }
}

TEST_CASE("a token of 100 MB") {
    constexpr std::size_t kSize = 100 * kMillion;
    const std::string digits(kSize, '7');
    for (const std::string_view before : {"", "a", "\"", "//", "#", "{", "0.", "-"}) {
        CAPTURE(before);
        std::string text(before);
        text += digits;
        const Tokens tokens = lex(text);
        CHECK(tokens.size() <= 3);
        const BoundAst bound = bind(kSource, tokens, parse(tokens));
        for (const auto& diagnostic : bound.diagnostics) CHECK(diagnostic.message.size() < 200);
    }
}

TEST_CASE("a line of 100 MB") {
    std::string text = "Group { MaterialIndex 0 ";
    while (text.size() < 100 * kMillion) text += "Sphere { center 1.25 -0.5 1e3 radius 12.125 } ";
    text += "}";
    const Tokens tokens = lex(text);
    const Cst cst = parse(tokens);
    CHECK(cst.nodes[0].end_token == tokens.size());
    CHECK(cst.kind(NodeId{1}) == NodeKind::kBlock);
    CHECK(cst.node(NodeId{1}).has_error == 0);
    CHECK(cst.node(NodeId{1}).end_token == tokens.size() - 1);
}

TEST_CASE("binary files give a bounded number of findings") {
    for (const std::string_view piece :
         {std::string_view("\xFF "), std::string_view("\0", 1), std::string_view("\" \n"),
          std::string_view("a\n"), std::string_view("{}"), std::string_view("\xFF\xFE\0P", 4)}) {
        CAPTURE(piece);
        const BoundAst bound = check_text(repeated(piece, kMillion));
        CHECK(!bound.diagnostics.empty());
        CHECK(bound.diagnostics.size() <= 10001);
    }
}
