// SPDX-License-Identifier: MIT
// The pages say what the program does: examples check clean, and what the written grammar of blocks
// can produce is read without an error.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <string>

#include "frontend/check/check.hpp"
#include "frontend/format/format.hpp"
#include "tools/docs/pages.hpp"

namespace cobble::docs {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> example(std::string_view name) {
    std::ifstream file(fs::path(COBBLE_ROOT) / "tools/docs/examples" /
                       fmt::format("{}.scene", name));
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

TEST_CASE("every block has an example, which is clean and formatted") {
    for (const grammar::BlockRow& row : grammar::blocks()) {
        CAPTURE(row.name);
        const auto text = example(row.name);
        REQUIRE(text.has_value());
        const frontend::CheckedScene scene = frontend::check(source::SourceId{0}, *text);
        for (const source::Diagnostic& diagnostic : scene.diagnostics) {
            FAIL_CHECK(diagnostic.message);
        }
        CHECK(frontend::format(*text).text == *text);
        const std::string shown = shown_part(*text);
        CHECK(shown.find(row.name) != std::string::npos);
        CHECK(shown.find("// e") == std::string::npos);
    }
}

TEST_CASE("the shown part of an example is what stands between the marks") {
    CHECK(shown_part("a\n") == "a\n");
    CHECK(shown_part("a\n  // example\n  b {\n\n    c\n  }\n  // end\nd\n") == "b {\n\n  c\n}\n");
}

/// Writes random sentences of the grammar of blocks.
class Speaker {
  public:
    explicit Speaker(std::uint32_t seed) : random_(seed) {
        for (const Rule& rule : block_grammar()) rules_[rule.name] = rule.body;
    }

    std::string speak(const Expression& expression, int depth) {
        switch (expression.form) {
            case Form::kText:
                return expression.text + " ";
            case Form::kRule:
                return rules_.contains(expression.text)
                           ? speak(rules_.at(expression.text), depth + 1)
                           : value(expression.text) + " ";
            case Form::kSequence:
                return all(expression.parts, depth);
            case Form::kChoice:
                return speak(expression.parts[random_() % expression.parts.size()], depth);
            case Form::kOptional:
                return random_() % 2 == 0 ? speak(expression.parts[0], depth) : "";
            case Form::kMany: {
                std::string text;
                const std::size_t count = depth > 8 ? 0 : random_() % 5;
                for (std::size_t i = 0; i < count; ++i) text += speak(expression.parts[0], depth);
                return text;
            }
            default:
                FAIL("the grammar of blocks has a form that nobody speaks yet");
                return {};
        }
    }

    std::string scene() { return speak(rules_.at("scene"), 0); }

  private:
    std::string all(const std::vector<Expression>& parts, int depth) {
        std::string text;
        for (const Expression& part : parts) text += speak(part, depth);
        return text;
    }

    std::string number() {
        constexpr const char* kNumbers[] = {"0", "1", "-.5", "5.", "+2.25", "1e-3", "1E+3"};
        return kNumbers[random_() % std::size(kNumbers)];
    }

    std::string numbers(int count) {
        std::string text = number();
        for (int i = 1; i < count; ++i) text.append(" ").append(number());
        return text;
    }

    std::string value(const std::string& rule) {
        if (rule == "number") return number();
        if (rule == "integer" || rule == "count" || rule == "material") return "3";
        if (rule == "vector2") return numbers(2);
        if (rule == "vector3") return numbers(3);
        if (rule == "rgb") return random_() % 3 == 0 ? "#ffeedd" : numbers(3);
        if (rule == "numbers4") return numbers(4);
        if (rule == "numbers16") return numbers(16);
        if (rule == "path") return random_() % 2 == 0 ? "tex/a.bmp" : "\"a b.png\"";
        if (rule == "filter") return "nearest";
        if (rule == "label") return fmt::format("name_{}", ++labels_);
        FAIL("the grammar of blocks has a value that nobody speaks yet: " << rule);
        return {};
    }

    std::mt19937 random_;  // the same numbers on every standard library
    std::map<std::string, Expression> rules_;
    int labels_ = 0;
};

TEST_CASE("what the written grammar produces is read without an error") {
    std::size_t longest = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        const std::string text = Speaker(seed).scene();
        longest = std::max(longest, text.size());
        const frontend::Tokens tokens = frontend::lex(text);
        const frontend::Cst cst = frontend::parse(tokens);
        const auto bound = frontend::bind(source::SourceId{0}, tokens, cst);
        CAPTURE(text);
        for (const source::Diagnostic& diagnostic : bound.diagnostics) {
            FAIL_CHECK(diagnostic.message);
        }
        if (!bound.diagnostics.empty()) break;
    }
    CHECK(longest > 1000);
}

TEST_CASE("EBNF shows its operators and keeps lines short") {
    const Expression digit = described("0-9");
    CHECK(ebnf({"a", compound(Form::kSequence, {text("x"), rule("b")})}) == "a ::= \"x\" b");
    CHECK(ebnf({"a", text("\"")}) == "a ::= '\"'");
    CHECK(ebnf({"a", compound(Form::kMany, {compound(Form::kChoice, {rule("b"), digit})})}) ==
          "a ::= (b | <0-9>)*");
    CHECK(ebnf({"a", compound(Form::kNotAhead, {compound(Form::kAhead, {rule("b")})})}) ==
          "a ::= !(&b)");
    CHECK(ebnf({"a", compound(Form::kRepeat, {digit}, 6)}) == "a ::= <0-9>{6}");
    std::vector<Expression> many;
    for (int i = 0; i < 40; ++i) many.push_back(rule(fmt::format("rule_{}", i)));
    std::string wide = ebnf({"a", compound(Form::kChoice, many)});
    CHECK(wide.find("\n      | rule_") != std::string::npos);
    while (!wide.empty()) {
        const std::size_t end = std::min(wide.find('\n'), wide.size() - 1);
        CHECK(end <= 96);
        wide.erase(0, end + 1);
    }
}

TEST_CASE("a railroad diagram holds all its stations inside its borders") {
    for (const Rule& rule : block_grammar()) {
        const std::string svg = railroad({rule});
        double width = 0;
        double height = 0;
        REQUIRE(std::sscanf(svg.c_str(),
                            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%lf\" "
                            "height=\"%lf\"",
                            &width, &height) == 2);
        std::size_t at = 0;
        int boxes = 0;
        while ((at = svg.find("<rect class=\"", at + 1)) != std::string::npos) {
            double x = 0;
            double y = 0;
            double w = 0;
            double h = 0;
            if (std::sscanf(svg.c_str() + at,
                            "<rect class=\"%*[a-z]\" x=\"%lf\" y=\"%lf\" width="
                            "\"%lf\" height=\"%lf\"",
                            &x, &y, &w, &h) != 4) {
                continue;  // the background
            }
            ++boxes;
            CHECK(x >= 0);
            CHECK(y >= 0);
            CHECK(x + w <= width);
            CHECK(y + h <= height);
        }
        CHECK(boxes >= 2);
    }
}

}  // namespace
}  // namespace cobble::docs
