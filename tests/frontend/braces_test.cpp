// SPDX-License-Identifier: MIT
// One brace deleted from a good file is one error, and nothing follows from it.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/source/line_index.hpp"
#include "tests/frontend/case_text.hpp"
#include "tests/support/corpus.hpp"

using namespace cobble;

namespace {

constexpr source::SourceId kSource{0};

/// Scenes without errors: our own and, where they are at hand, published ones.
std::vector<std::string> good_files() {
    std::vector<std::string> files = test::files_in(COBBLE_ROOT "/scenes", ".scene");
    files.push_back(COBBLE_ROOT "/tests/frontend/cases/valid_everything.scene");
    const std::string corpus = test::corpus().string();
    if (!corpus.empty()) {
        for (const std::string& path : test::files_in(corpus, ".txt")) {
            if (path.find("/scene") != std::string::npos) files.push_back(path);
        }
    }
    return files;
}

/// What is odd but no error, as texts.
std::vector<std::string> warnings_of(const frontend::CheckedScene& scene) {
    std::vector<std::string> warnings;
    for (const auto& diagnostic : scene.diagnostics) {
        if (diagnostic.severity != source::Severity::kError) {
            warnings.push_back(std::string(diagnostic.code->code) + diagnostic.message);
        }
    }
    std::sort(warnings.begin(), warnings.end());
    return warnings;
}

/// The beginning of the next block's name after `offset`, or the end of the text.
std::size_t next_block(const frontend::CheckedScene& good, std::size_t offset) {
    for (const auto& block : good.ast.blocks) {
        const auto token = good.cst.node(block.cst).first_token;
        const std::size_t begin = good.tokens.range(frontend::TokenId{token}).begin;
        if (begin > offset) return begin;
    }
    return good.tokens.text.size();
}

}  // namespace

TEST_CASE("scenes of our own have no findings") {
    for (const std::string& path : test::files_in(COBBLE_ROOT "/scenes", ".scene")) {
        const std::string text = test::read_file(path);
        CAPTURE(path);
        CHECK(test::describe(text, frontend::check(kSource, text).diagnostics) == "nothing\n");
    }
}

TEST_CASE("every deleted closing brace is one error, no later than the next block") {
    for (const std::string& path : good_files()) {
        const std::string text = test::read_file(path);
        // Larger files only repeat what smaller ones have, in quadratic time.
        if (text.size() > 20000) continue;
        const auto good = frontend::check(kSource, text);
        REQUIRE(!good.has_errors());
        const auto warnings = warnings_of(good);
        for (std::uint32_t i = 0; i < good.tokens.size(); ++i) {
            if (good.tokens.kind({i}) != frontend::TokenKind::kCloseBrace) continue;
            const std::size_t at = good.tokens.range({i}).begin;
            std::string broken = text;
            broken.erase(at, 1);
            const auto scene = frontend::check(kSource, broken);
            const std::string found = test::describe(broken, scene.diagnostics);
            CAPTURE(path);
            CAPTURE(source::LineIndex(text).locate(static_cast<std::uint32_t>(at)).line);
            CAPTURE(found);
            const auto is_error = [](const source::Diagnostic& diagnostic) {
                return diagnostic.severity == source::Severity::kError;
            };
            CHECK(std::ranges::count_if(scene.diagnostics, is_error) == 1);
            const auto error = std::ranges::find_if(scene.diagnostics, is_error);
            if (error != scene.diagnostics.end()) {
                CHECK(error->span.begin <= next_block(good, at));
            }
            const auto after = warnings_of(scene);
            CHECK(std::ranges::includes(warnings, after));
        }
    }
}
