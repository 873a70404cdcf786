// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "frontend/names/suggest.hpp"

using namespace cobble::frontend;

namespace {

/// The textbook table, all of it, without limits.
std::size_t whole_table(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1,
                                d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a.size()][b.size()];
}

}  // namespace

TEST_CASE("the banded edit distance is the whole table's, cut at the limit") {
    std::mt19937 random(1);
    for (int round = 0; round < 20000; ++round) {
        const auto word = [&] {
            std::string text(random() % 9, 'a');
            for (char& c : text) c = static_cast<char>('a' + random() % 3);
            return text;
        };
        const std::string a = word();
        const std::string b = word();
        for (std::size_t limit = 0; limit <= 3; ++limit) {
            CAPTURE(a);
            CAPTURE(b);
            REQUIRE(edit_distance(a, b, limit) == std::min(whole_table(a, b), limit + 1));
        }
    }
}

TEST_CASE("near names") {
    constexpr std::array<std::string_view, 8> names = {
        "center", "direction", "up", "angle", "aperture", "obj_file", "diffuseColor", "Materials"};
    CHECK(nearest_name("angles", names) == "angle");
    CHECK(nearest_name("agnle", names) == "angle");
    CHECK(nearest_name("objFile", names) == "obj_file");
    CHECK(nearest_name("DIFFUSECOLOR", names) == "diffuseColor");
    CHECK(nearest_name("difuseColour", names) == "diffuseColor");
    CHECK(nearest_name("materials", names) == "Materials");
    CHECK(nearest_name("UP", names) == "up");
    CHECK(nearest_name("matrials", names) == "Materials");
    CHECK(nearest_name("upp", names).empty());
    CHECK(nearest_name("radius", names).empty());
    CHECK(nearest_name("angle", names).empty());
    CHECK(nearest_name("", names).empty());
    CHECK(nearest_name(std::string(1000, 'a'), names).empty());
    constexpr std::array<std::string_view, 4> vertices = {"vertex0", "vertex1", "vertex2",
                                                          "vertex0"};
    CHECK(near_names("vertex", vertices) ==
          std::vector<std::string_view>{"vertex0", "vertex1", "vertex2"});
    CHECK(near_names("Vertex1", vertices, 2) ==
          std::vector<std::string_view>{"vertex1", "vertex0"});
}
