// SPDX-License-Identifier: MIT
#include "frontend/format/space_edits.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "frontend/format/format.hpp"

namespace cobble::frontend {
namespace {

std::string applied(std::string text, const std::vector<SpaceEdit>& edits) {
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
        text.replace(edit->begin, edit->end - edit->begin, edit->text);
    }
    return text;
}

TEST_CASE("edits of white space lead from a text to its formatted one") {
    const std::string untidy = "Sphere{center 0 0  0\n\n\n\nradius 1}// it \nGroup   {\n}";
    const std::string tidy = format(untidy).text;
    REQUIRE(tidy != untidy);
    const auto edits = space_edits(untidy, tidy);
    CHECK(edits.size() > 4);
    std::uint32_t before = 0;
    for (const SpaceEdit& edit : edits) {
        CHECK(edit.begin >= before);
        CHECK(edit.end - edit.begin < untidy.size() / 2);
        CHECK(edit.text.find_first_not_of(" \n") == std::string::npos);
        before = edit.end;
    }
    CHECK(applied(untidy, edits) == tidy);
    CHECK(space_edits(tidy, tidy).empty());
    CHECK(space_edits("", "").empty());
    CHECK(applied("a", space_edits("a", "a\n")) == "a\n");
    CHECK(applied("\n\na", space_edits("\n\na", "a")) == "a");
}

TEST_CASE("texts that differ in more than white space are replaced as a whole") {
    for (const auto& [before, after] :
         {std::pair("a b", "a c"), std::pair("a", "a b"), std::pair("a b", "a")}) {
        const auto edits = space_edits(before, after);
        REQUIRE(edits.size() == 1);
        CHECK(edits[0].begin == 0);
        CHECK(applied(before, edits) == after);
    }
}

}  // namespace
}  // namespace cobble::frontend
