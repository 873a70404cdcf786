// SPDX-License-Identifier: MIT
// Mutated scenes: nothing crashes, and every change that is offered does what it says.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/check/verify_fixes.hpp"
#include "tests/frontend/case_text.hpp"
#include "tests/frontend/format_mutate.hpp"
#include "tests/support/corpus.hpp"

using namespace cobble;

namespace {

constexpr source::SourceId kSource{0};

std::vector<std::string> seeds() {
    std::vector<std::string> texts;
    const auto add = [&texts](const std::string& folder, std::string_view ending) {
        if (folder.empty()) return;
        for (const std::string& path : test::files_in(folder, ending)) {
            std::string text = test::read_file(path);
            if (text.size() < 4000) texts.push_back(std::move(text));
        }
    };
    add(COBBLE_ROOT "/tests/frontend/cases", ".scene");
    add(test::corpus().string(), ".txt");
    return texts;
}

}  // namespace

TEST_CASE("changes that are offered for mutated scenes remove their finding and add none") {
    const auto texts = seeds();
    REQUIRE(!texts.empty());
    frontend::testing::Random random(7);
    std::size_t offered = 0;
    for (int round = 0; round < 8000; ++round) {
        const std::string text = frontend::testing::damaged(texts, random);
        const auto scene = frontend::check(kSource, text);
        REQUIRE(scene.material_of_block.size() == scene.ast.blocks.size());
        for (const auto& diagnostic : scene.diagnostics) {
            REQUIRE(diagnostic.span.begin <= diagnostic.span.end);
            REQUIRE(diagnostic.span.end <= text.size());
            for (const auto& fix : diagnostic.fixes) {
                CAPTURE(text);
                CAPTURE(fix.title);
                const auto changed = frontend::apply(text, kSource, fix);
                REQUIRE(changed.has_value());
                const auto after = frontend::check_unverified(kSource, *changed);
                const auto read = frontend::newly_read(scene, diagnostic, fix, after);
                const auto known = std::ranges::count_if(after.diagnostics, [&](const auto& left) {
                    return left.span.begin < read.begin || left.span.begin >= read.end;
                });
                REQUIRE(static_cast<std::size_t>(known) < scene.diagnostics.size());
                ++offered;
            }
        }
    }
    // The mutations do reach findings that can be mended.
    CHECK(offered > 1000);
}

TEST_CASE("a scene whose every line is wrong neither floods memory nor takes forever") {
    std::string text = "PerspectiveCamera {\n";
    for (int i = 0; i < 30000; ++i) text += "    angle 200\n";
    text += "}\nGroup {\n";
    for (int i = 0; i < 30000; ++i) text += "    MaterialIndex 7\n    Sphere {}\n";
    text += "}\n";
    const auto scene = frontend::check(kSource, text);
    CHECK(scene.has_errors());
    CHECK(scene.diagnostics.size() <= 30000);
}
