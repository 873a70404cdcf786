// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "frontend/check/verify_fixes.hpp"
#include "frontend/names/dialects.hpp"
#include "grammar/vocabulary.hpp"

using namespace cobble;
using namespace cobble::frontend;

namespace {

constexpr source::SourceId kSource{0};

struct Place {
    std::string_view word;
    std::string_view block;
};
constexpr Place kPlaces[] = {
#define COBBLE_DIALECT(word, block, dialect, modern, rewrite, advice) {#word, block},
#include "frontend/names/dialects.def"
};

/// `text` is one entry, beginning with its name; the result has its fix applied.
std::string rewritten(std::string_view text, std::string_view block) {
    const Tokens tokens = lex(text);
    const DialectWord* word = find_dialect_word(tokens.text_of(TokenId{0}), block);
    REQUIRE(word != nullptr);
    const auto fix = dialect_fix(*word, kSource, tokens, TokenId{0}, TokenId{tokens.size() - 1});
    if (!fix) return "";
    CHECK(!fix->safe);
    return apply(text, kSource, *fix).value();
}

}  // namespace

TEST_CASE("no word of another dialect is a word of this one in the same place") {
    std::set<std::pair<std::string_view, std::string_view>> seen;
    for (const Place& place : kPlaces) {
        CAPTURE(place.word);
        const DialectWord* entry = find_dialect_word(place.word, place.block);
        REQUIRE(entry != nullptr);
        const DialectWord& word = *entry;
        CHECK(word.word == place.word);
        CHECK(word.block == place.block);
        CHECK(seen.insert({word.word, word.block}).second);
        CHECK(!word.advice.empty());
        CHECK(!word.advice.ends_with('.'));
        const grammar::BlockRow* block = grammar::find_block(word.block);
        CHECK((block != nullptr) == !word.block.empty());
        if (block != nullptr) CHECK(grammar::find_field(block->id, word.word) == nullptr);
        CHECK(grammar::find_block(word.word) == nullptr);
        // What is named as the word of today is one.
        if (!word.modern.empty()) CHECK(grammar::is_vocabulary_name(word.modern));
    }
}

TEST_CASE("a word is found where it stands, a block's name anywhere") {
    CHECK(find_dialect_word("exponent", "PhongMaterial")->modern == "shininess");
    CHECK(find_dialect_word("type", "Noise")->block == "Noise");
    CHECK(find_dialect_word("type", "Sphere") == nullptr);
    CHECK(find_dialect_word("Cube", "Transform")->modern == "Box");
    CHECK(find_dialect_word("OrthographicCamera", "")->dialect == Dialect::k2004);
    CHECK(find_dialect_word("Sphere", "Group") == nullptr);
    CHECK(find_dialect_word("Light", "Lights")->modern == "PointLight");
    CHECK(find_dialect_word("Light", "") == nullptr);
}

TEST_CASE("the rewrites that one entry is enough for") {
    CHECK(rewritten("exponent 20", "Material") == "shininess 20");
    CHECK(rewritten("indexOfRefraction 1.5", "PhongMaterial") == "refractionIndex 1.5");
    CHECK(rewritten("attenuation 1.0 0 .25", "PointLight") == "falloff .25");
    CHECK(rewritten("attenuation +1 -0\n 2e-3", "PointLight") == "falloff 2e-3");
    CHECK(rewritten("attenuation 1 0.1 .25", "PointLight").empty());
    CHECK(rewritten("attenuation 0 0 1", "PointLight").empty());
    CHECK(rewritten("attenuation 1 0 -1", "PointLight").empty());
    CHECK(rewritten("attenuation 1 0", "PointLight").empty());
    CHECK(rewritten("attenuation 1 0 x", "PointLight").empty());
    CHECK(rewritten("Matrix {\n 1 2 3 4\n 5 6 7 8\n 9 10 11 12\n 0 0 0 1 }", "Transform") ==
          "Matrix4f {\n 1 5 9 0\n 2 6 10 0\n 3 7 11 0\n 4 8 12 1 }");
    CHECK(rewritten("Matrix { 1 2 3 }", "Transform").empty());
    CHECK(rewritten("diffuse 1 1 1", "Material").empty());
}

TEST_CASE("names that begin a scene") {
    for (const char* name : {"PerspectiveCamera", "Lights", "Background", "Materials", "Group",
                             "OrthographicCamera", "Camera", "Scene", "SkyBox"}) {
        CHECK(is_top_level_name_of_any_dialect(name));
    }
    for (const char* name : {"", "Sphere", "group", "Readme", "PointLight", "center", "Matrix"}) {
        CHECK(!is_top_level_name_of_any_dialect(name));
    }
}
