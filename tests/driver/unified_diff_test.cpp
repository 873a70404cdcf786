// SPDX-License-Identifier: MIT
#include "tools/driver/unified_diff.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cobble::driver {
namespace {

// What `patch` would make of `before`: hunk by hunk, each line checked against the text.
std::string patched(std::string_view before, std::string_view diff) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < before.size();) {
        const std::size_t end = std::min(before.find('\n', at), before.size() - 1) + 1;
        lines.emplace_back(before.substr(at, end - at));
        at = end;
    }
    std::string result;
    std::size_t next = 0;
    std::string last;
    while (!diff.empty()) {
        const std::size_t end = std::min(diff.find('\n'), diff.size() - 1) + 1;
        const std::string line(diff.substr(0, end));
        diff.remove_prefix(end);
        if (line.starts_with("--- ") || line.starts_with("+++ ")) continue;
        if (line.starts_with("@@ -")) {
            std::size_t first = std::stoul(line.substr(4));
            const bool empty = line.substr(4, line.find(' ', 4) - 4).ends_with(",0");
            if (!empty) --first;
            while (next < first) result += lines.at(next++);
        } else if (line.starts_with("\\")) {
            if (last != "-") result.pop_back();
        } else if (line[0] == ' ' || line[0] == '-') {
            std::string expected = lines.at(next++);
            if (!expected.ends_with('\n')) expected += '\n';
            REQUIRE(line.substr(1) == expected);
            if (line[0] == ' ') result += line.substr(1);
            last = line.substr(0, 1);
        } else {
            REQUIRE(line[0] == '+');
            result += line.substr(1);
            last = "+";
        }
    }
    while (next < lines.size()) result += lines[next++];
    return result;
}

std::uint32_t next_random(std::uint32_t& state) {
    state = state * 1664525U + 1013904223U;  // Numerical Recipes' generator: good enough to vary
    return state >> 16U;
}

}  // namespace

TEST_CASE("equal texts have no difference") {
    CHECK(unified_diff("a\nb\n", "a\nb\n", "x", "y").empty());
}

TEST_CASE("a difference is written as diff -u writes it") {
    CHECK(unified_diff("1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nfive\n6\n7\n8\n9\n", "old",
                       "new") ==
          "--- old\n+++ new\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n");
    CHECK(unified_diff("", "a\n", "old", "new") == "--- old\n+++ new\n@@ -0,0 +1 @@\n+a\n");
    CHECK(unified_diff("a", "a\n", "old", "new") ==
          "--- old\n+++ new\n@@ -1 +1 @@\n-a\n\\ No newline at end of file\n+a\n");
    CHECK(unified_diff("\na\n", "a\n", "x", "y") == "--- x\n+++ y\n@@ -1,2 +1 @@\n-\n a\n");
}

TEST_CASE("changes whose context would touch stand in one hunk") {
    const std::string six = "1\n2\n3\n4\n5\n6\n";
    CHECK(unified_diff(" a\n" + six + " b\n", "a\n" + six + "b\n", "x", "y") ==
          "--- x\n+++ y\n@@ -1,8 +1,8 @@\n- a\n+a\n 1\n 2\n 3\n 4\n 5\n 6\n- b\n+b\n");
    CHECK(unified_diff(" a\n" + six + "7\n b\n", "a\n" + six + "7\nb\n", "x", "y") ==
          "--- x\n+++ y\n@@ -1,4 +1,4 @@\n- a\n+a\n 1\n 2\n 3\n"
          "@@ -6,4 +6,4 @@\n 5\n 6\n 7\n- b\n+b\n");
}

TEST_CASE("applying a difference to the first text gives the second") {
    std::uint32_t state = 7;
    for (int round = 0; round < 3000; ++round) {
        const auto text = [&state] {
            std::string result;
            const std::uint32_t lines = next_random(state) % 24;
            const std::uint32_t letters = 1 + next_random(state) % 12;
            for (std::uint32_t i = 0; i < lines; ++i) {
                result += static_cast<char>('a' + next_random(state) % letters);
                result += '\n';
            }
            if (!result.empty() && next_random(state) % 4 == 0) result.pop_back();
            return result;
        };
        const std::string before = text();
        const std::string after = text();
        CAPTURE(before);
        CAPTURE(after);
        REQUIRE(patched(before, unified_diff(before, after, "a", "b")) == after);
    }
}

TEST_CASE("texts that differ everywhere cost no square") {
    std::string before;
    std::string after;
    for (int i = 0; i < 200000; ++i) {
        before += "x\n";
        after += i % 3 == 0 ? "y\n" : "x \n";
    }
    CHECK(patched(before, unified_diff(before, after, "a", "b")) == after);
}

}  // namespace cobble::driver
