// SPDX-License-Identifier: MIT
#include "tools/driver/report/reporter.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

const source::DiagnosticCode kCode("test-finding", source::Severity::kError, "a finding",
                                   "it is found", "x", "do not look");

struct Scene {
    explicit Scene(std::string_view text) : id(sources.add("a.scene", std::string(text))) {}

    // A finding about the first `what` of the text.
    source::Diagnostic about(std::string_view what) {
        const auto begin = static_cast<std::uint32_t>(sources.text(id).find(what));
        source::Diagnostic result;
        result.code = &kCode;
        result.message = "found it";
        result.span = {id, begin, begin + static_cast<std::uint32_t>(what.size())};
        return result;
    }

    source::SourceMap sources;
    source::SourceId id;
};

std::string report(ReportFormat format, const Scene& scene, const source::Diagnostic& finding,
                   const ReportStyle& style = {}) {
    std::string text;
    const auto reporter =
        make_reporter(format, style, [&text](std::string_view piece) { text += piece; });
    reporter->file({scene.id, &scene.sources, {finding}});
    reporter->finish({1, 1, 0});
    return text;
}

// The second and third line of the human report: the source and the carets under it.
std::string excerpt(std::string_view text, std::string_view what, unsigned columns = 100) {
    Scene scene(text);
    const std::string all =
        report(ReportFormat::kHuman, scene, scene.about(what), {false, columns});
    return all.substr(all.find('\n') + 1);
}

}  // namespace

TEST_CASE("carets stand under the place") {
    CHECK(excerpt("one two three\n", "two") == "  1 | one two three\n    |     ^^^\n");
    CHECK(excerpt("\ttab\tx\n", "x") == "  1 |     tab x\n    |         ^\n");
    CHECK(excerpt("\ta\tbc\n", "\tbc") == "  1 |     a   bc\n    |      ^^^^^\n");
    CHECK(excerpt("漢字 x\n", "x") == "  1 | 漢字 x\n    |      ^\n");
    CHECK(excerpt("漢字 x\n", "字") == "  1 | 漢字 x\n    |   ^^\n");
    CHECK(excerpt("e\u0301 x\n", "x") == "  1 | e\u0301 x\n    |   ^\n");
    CHECK(excerpt("\xEF\xBB\xBFx y\n", "y") == "  1 | x y\n    |   ^\n");
    CHECK(excerpt("a\r\nbc d\r\n", "d") == "  2 | bc d\n    |    ^\n");
}

TEST_CASE("a place at the end of a line has a caret too") {
    Scene scene("abc\n");
    source::Diagnostic finding = scene.about("abc");
    finding.span.begin = finding.span.end = 3;
    const std::string text = report(ReportFormat::kHuman, scene, finding);
    CHECK(text == "a.scene:1:4: error: found it [test-finding]\n  1 | abc\n    |    ^\n");
}

TEST_CASE("a long line is cut around the place") {
    const std::string text =
        excerpt(std::string(5000, 'a') + " here " + std::string(100000, 'b'), "here", 60);
    CHECK(text.size() < 200);
    const std::size_t line = text.find("here");
    const std::size_t carets = text.find("^^^^") - text.find('\n') - 1;
    CHECK(line == carets);
}

TEST_CASE("a file cannot send commands to the terminal") {
    const std::string text = excerpt("\x1b[2J x \xff\n", "x");
    CHECK(text.find('\x1b') == std::string::npos);
    CHECK(text.find('\xff') == std::string::npos);
    CHECK(text.find("^") - text.find('\n') - 1 == 6 + 5);
}

TEST_CASE("JSON has the fields of version 1") {
    Scene scene("é x\n");
    source::Diagnostic finding = scene.about("x");
    finding.notes = {"a note"};
    finding.related = {{{scene.id, 0, 2}, "over there"}};
    finding.fixes = {{"remove it", true, {{finding.span, ""}}}};
    const auto json = nlohmann::json::parse(report(ReportFormat::kJson, scene, finding));
    const auto range = nlohmann::json::parse(
        R"({"start": {"line": 1, "column": 3, "offset": 3},
            "end": {"line": 1, "column": 4, "offset": 4}})");
    const auto there = nlohmann::json::parse(
        R"({"start": {"line": 1, "column": 1, "offset": 0},
            "end": {"line": 1, "column": 2, "offset": 2}})");
    const nlohmann::json expected = {
        {"version", 1},
        {"files",
         {{{"path", "a.scene"},
           {"diagnostics",
            {{{"code", "test-finding"},
              {"severity", "error"},
              {"message", "found it"},
              {"range", range},
              {"notes", {"a note"}},
              {"help", "cobble explain test-finding"},
              {"related", {{{"path", "a.scene"}, {"message", "over there"}, {"range", there}}}},
              {"fixes",
               {{{"title", "remove it"},
                 {"safe", true},
                 {"edits", {{{"range", range}, {"text", ""}}}}}}}}}}}}},
        {"summary", {{"files", 1}, {"errors", 1}, {"warnings", 0}}}};
    CHECK(json == expected);
}

TEST_CASE("a finding about no place has a null range") {
    Scene scene("x\n");
    source::Diagnostic finding = scene.about("x");
    finding.span = {};
    const auto json = nlohmann::json::parse(report(ReportFormat::kJson, scene, finding));
    CHECK(json["files"][0]["diagnostics"][0]["range"].is_null());
    CHECK(report(ReportFormat::kHuman, scene, finding) ==
          "a.scene: error: found it [test-finding]\n");
    CHECK(report(ReportFormat::kGithub, scene, finding) ==
          "::error file=a.scene,title=test-finding::found it\n");
}

TEST_CASE("bytes that are no UTF-8 do not break JSON") {
    Scene scene("\xff x\n");
    source::Diagnostic finding = scene.about("x");
    finding.message = "odd \xff";
    for (const auto format :
         {ReportFormat::kJson, ReportFormat::kJsonLines, ReportFormat::kSarif}) {
        CHECK(report(format, scene, finding).find("odd \xEF\xBF\xBD") != std::string::npos);
    }
}

TEST_CASE("widths are those of terminals") {
    CHECK(width_of('a') == 1);
    CHECK(width_of(0x301) == 0);
    CHECK(width_of(0x6F22) == 2);
    CHECK(width_of(0x1F600) == 2);
    CHECK(width_of(0x200D) == 0);
    CHECK(width_of(0xE9) == 1);
}

}  // namespace cobble::driver
