// SPDX-License-Identifier: MIT
// Mutated scenes: nothing crashes, and every change that is offered does what it says.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "frontend/check/check.hpp"
#include "frontend/check/verify_fixes.hpp"
#include "tests/frontend/case_text.hpp"
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

/// One small change of the kinds that typing, pasting and broken files make.
void mutate(std::string& text, const std::vector<std::string>& seeds, std::mt19937& random) {
    const auto below = [&random](std::size_t n) { return n == 0 ? 0 : random() % n; };
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min<std::size_t>(below(24), text.size() - at);
    static const char* const kPieces[] = {"{",     "}",      "0",       " -1 ",  "1e999", "//",
                                          "\"",    "\n",     "\r",      "angle", "color", "Group {",
                                          "1.2.3", "Motion", "#ff0000", "\xff",  "0.5f",  "Sphere"};
    switch (random() % 6) {
        case 0:
            text.erase(at, length);
            break;
        case 1:
            text.insert(at, kPieces[random() % std::size(kPieces)]);
            break;
        case 2:
            text.insert(below(text.size() + 1), text.substr(at, length));
            break;
        case 3:
            if (at < text.size()) text[at] = static_cast<char>(random() & 0xffU);
            break;
        case 4: {
            const std::string& other = seeds[random() % seeds.size()];
            text.insert(at, other.substr(below(other.size()), below(40)));
            break;
        }
        default: {
            // A whole line, as an editor moves them.
            const std::size_t begin = text.rfind('\n', at == 0 ? 0 : at - 1);
            const std::size_t end = text.find('\n', at);
            if (begin == std::string::npos || end == std::string::npos || begin >= end) break;
            const std::string line = text.substr(begin, end - begin);
            if (random() % 2 == 0) text.erase(begin, end - begin);
            text.insert(below(text.size() + 1), line);
        }
    }
}

}  // namespace

TEST_CASE("changes that are offered for mutated scenes remove their finding and add none") {
    const auto texts = seeds();
    REQUIRE(!texts.empty());
    std::mt19937 random(7);
    std::size_t offered = 0;
    for (int round = 0; round < 8000; ++round) {
        std::string text = texts[random() % texts.size()];
        const auto changes = 1 + random() % 4;
        for (std::size_t i = 0; i < changes; ++i) mutate(text, texts, random);
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
                REQUIRE(after.diagnostics.size() < scene.diagnostics.size());
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
