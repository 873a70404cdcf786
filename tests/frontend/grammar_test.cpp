// SPDX-License-Identifier: MIT
// The two grammars as such: no rule can loop, and every rule matches something in the cases.
#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <tao/pegtl.hpp>
#include <tao/pegtl/contrib/analyze.hpp>
#include <tao/pegtl/contrib/coverage.hpp>

#include "frontend/parse/actions.hpp"
#include "frontend/parse/token_input.hpp"
#include "frontend/parse/tree_builder.hpp"
#include "grammar/lexical.hpp"
#include "grammar/structure.hpp"

using namespace cobble;
using namespace cobble::frontend;
namespace pegtl = tao::pegtl;

namespace {

constexpr std::string_view kTexts[] = {
    "\xEF\xBB\xBF// comment\n"
    "PerspectiveCamera main { center 1 1.2.3 3 direction 0.5f -0.8 angle 30 angles 3 }\n"
    "Materials { PhongMaterial { diffuseColor #ff8000 texture \"a b.bmp\" bump \"open\n"
    "  Noise { octaves } } numMaterials 2 }\n"
    "Lights { Sphere PointLight lamp position 0 0 0 color 1. .5 1e-3//c\n}\n"
    "Group { 1 2 MaterialIndex stone { 1 } nonsense in prose 4 { 2 }\n"
    "  Transform { Rotate { 0 1 0 90 } Sphere ball { center 0 0 0 radius 1 } } }\n",
    // The } of PointLight is missing, and seen to be so by the indentation of the next one.
    "Lights {\n    PointLight {\n        color 1 1 1\n}\nGroup {\n}\n",
    "Lights {\n    PointLight {\n        color 1 1 1\n}\n",
};

// The rules of ours, not the anonymous ones between them, that never matched.
std::string unmatched(const pegtl::coverage_result& result, std::string_view space) {
    std::string names;
    for (const auto& [name, entry] : result) {
        if (name.starts_with(space) && entry.success == 0) names += std::string(name) + "\n";
    }
    return names;
}

}  // namespace

TEST_CASE("no rule of the grammars can loop") {
    CHECK(pegtl::analyze<grammar::lexical::text>(1) == 0);
    CHECK(pegtl::analyze<grammar::structure::file>(1) == 0);
}

TEST_CASE("every rule of the lexical grammar matches somewhere") {
    pegtl::coverage_result result;
    for (const std::string_view text : kTexts) {
        pegtl::memory_input<pegtl::tracking_mode::lazy> in(text, "");
        CHECK(pegtl::coverage<grammar::lexical::text>(in, result));
    }
    CHECK(result.size() > 20);
    CHECK(unmatched(result, "cobble::") == "");
}

TEST_CASE("every rule of the grammar of tokens matches somewhere") {
    pegtl::coverage_result result;
    for (const std::string_view text : kTexts) {
        const Tokens tokens = lex(text);
        Cst cst;
        TreeBuilder builder(tokens, cst);
        TokenInput in(tokens, builder);
        CHECK(pegtl::coverage<grammar::structure::file, ParseAction>(in, result, builder));
    }
    CHECK(result.size() > 25);
    CHECK(unmatched(result, "cobble::") == "");
}
