// SPDX-License-Identifier: MIT
// Case files: NAME.scene and, beside it, NAME.expected with everything that is found in it.
// COBBLE_UPDATE=1 rewrites the expectations; review them before they are committed.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include "frontend/check/check.hpp"
#include "tests/frontend/case_text.hpp"
#include "tests/support/corpus.hpp"

using namespace cobble;

namespace {

constexpr source::SourceId kSource{0};
const std::string kFolder = COBBLE_ROOT "/tests/frontend/cases";

/// Codes about files come from the loading of assets and have their cases there.
bool needs_files(const source::DiagnosticCode& code) { return code.code.starts_with("asset-"); }

/// What an example cannot hold, since pages are text of sensible length.
std::string made_example(std::string_view code) {
    if (code == "invalid-utf8") return "Group { }\xff";
    if (code == "not-text") return "\x89PNG" + std::string(4, '\0');
    if (code != "too-many-errors") return "";
    std::string text;
    for (int i = 0; i < 10002; ++i) text += "} ";
    return text;
}

}  // namespace

TEST_CASE("every case gives what its expectation says") {
    const bool update = std::getenv("COBBLE_UPDATE") != nullptr;
    const auto files = test::files_in(kFolder, ".scene");
    REQUIRE(!files.empty());
    for (const std::string& path : files) {
        CAPTURE(path);
        const std::string text = test::read_file(path);
        const auto scene = frontend::check(kSource, text);
        const std::string found = test::describe(text, scene.diagnostics);
        const std::string expectation = path.substr(0, path.rfind('.')) + ".expected";
        if (update) {
            std::ofstream(expectation, std::ios::binary) << found;
            continue;
        }
        CHECK(found == test::read_file(expectation));
    }
}

TEST_CASE("every code is printed by a case") {
    std::set<std::string_view> printed;
    for (const std::string& path : test::files_in(kFolder, ".scene")) {
        const std::string text = test::read_file(path);
        for (const auto& diagnostic : frontend::check(kSource, text).diagnostics) {
            printed.insert(diagnostic.code->code);
        }
    }
    for (const source::DiagnosticCode* code : source::all_codes()) {
        if (needs_files(*code) || code->code == "too-many-errors") continue;
        CAPTURE(code->code);
        CHECK(printed.contains(code->code));
    }
}

TEST_CASE("the example of every page shows what the page is about") {
    std::set<std::string_view> names;
    for (const source::DiagnosticCode* code : source::all_codes()) {
        CAPTURE(code->code);
        CHECK(names.insert(code->code).second);
        CHECK(!code->title.empty());
        CHECK(!code->why.empty());
        CHECK(!code->mend.empty());
        if (needs_files(*code)) continue;
        const std::string made = made_example(code->code);
        const auto scene = frontend::check(kSource, made.empty() ? code->example : made);
        bool shown = false;
        for (const auto& diagnostic : scene.diagnostics) shown |= diagnostic.code == code;
        CHECK(shown);
    }
}

TEST_CASE("messages are one sentence without a stop, at a place in the file") {
    for (const std::string& path : test::files_in(kFolder, ".scene")) {
        const std::string text = test::read_file(path);
        for (const auto& diagnostic : frontend::check(kSource, text).diagnostics) {
            CAPTURE(path);
            CAPTURE(diagnostic.message);
            CHECK(!diagnostic.message.empty());
            CHECK(!diagnostic.message.ends_with('.'));
            CHECK(diagnostic.message.find('\n') == std::string::npos);
            // The one finding about a whole file.
            if (diagnostic.code->code == "not-text") {
                CHECK(!diagnostic.span.valid());
                continue;
            }
            CHECK(diagnostic.span.source == kSource);
            CHECK(diagnostic.span.begin <= diagnostic.span.end);
            CHECK(diagnostic.span.end <= text.size());
        }
    }
}

TEST_CASE("published scenes have no errors" * doctest::test_suite("corpus")) {
    const std::string corpus = test::corpus_or_skip().string();
    if (corpus.empty()) return;
    for (const char* folder : {"ocw2012-a4", "ocw2012-a5", "fa2016-a4", "seed-block"}) {
        for (const std::string& path : test::files_in(corpus + "/" + folder, ".txt")) {
            if (path.find("scene") == std::string::npos) continue;
            CAPTURE(path);
            const std::string text = test::read_file(path);
            const auto scene = frontend::check(kSource, text);
            CAPTURE(test::describe(text, scene.diagnostics));
            CHECK(!scene.has_errors());
        }
    }
}
