// SPDX-License-Identifier: MIT
#include "tools/driver/ignore.hpp"

#include <doctest/doctest.h>

#include <string>

namespace cobble::driver {

TEST_CASE("globs match as in gitignore(5)") {
    CHECK(glob_matches("*.scene", "a.scene"));
    CHECK_FALSE(glob_matches("*.scene", "b/a.scene"));
    CHECK(glob_matches("**/*.scene", "a.scene"));
    CHECK(glob_matches("**/*.scene", "c/b/a.scene"));
    CHECK(glob_matches("a/**/z", "a/z"));
    CHECK(glob_matches("a/**/z", "a/b/c/z"));
    CHECK_FALSE(glob_matches("a/**/z", "ab/z"));
    CHECK(glob_matches("a/**", "a/b/c"));
    CHECK_FALSE(glob_matches("a/**", "a"));
    CHECK(glob_matches("?.[a-c]x", "q.bx"));
    CHECK_FALSE(glob_matches("?.[!a-c]x", "q.bx"));
    CHECK_FALSE(glob_matches("a?b", "a/b"));
    CHECK(glob_matches("\\*", "*"));
    CHECK_FALSE(glob_matches("\\*", "a"));
    CHECK(glob_matches("[", "["));
    CHECK(glob_matches("a[]]b", "a]b"));
    CHECK(glob_matches("", ""));
    CHECK_FALSE(glob_matches("a", ""));
}

TEST_CASE("a pattern of many stars is no trap") {
    std::string pattern;
    for (int i = 0; i < 1000; ++i) pattern += "*a";
    CHECK_FALSE(glob_matches(pattern + "b", std::string(4000, 'a')));
}

TEST_CASE("the last rule that matches wins") {
    IgnoreRules rules;
    rules.add("/p/", "# a remark\n*.tmp\n!keep.tmp\nout/\n/top\na/b\n\r\nspaced\\ \n");
    CHECK(rules.ignores("/p/x.tmp", false));
    CHECK(rules.ignores("/p/q/x.tmp", false));
    CHECK_FALSE(rules.ignores("/p/keep.tmp", false));
    CHECK(rules.ignores("/p/q/out", true));
    CHECK_FALSE(rules.ignores("/p/q/out", false));
    CHECK(rules.ignores("/p/top", false));
    CHECK_FALSE(rules.ignores("/p/q/top", false));
    CHECK(rules.ignores("/p/a/b", false));
    CHECK_FALSE(rules.ignores("/p/q/a/b", false));
    CHECK_FALSE(rules.ignores("/elsewhere/x.tmp", false));
    const std::size_t size = rules.size();
    rules.add("/p/q/", "!x.tmp\n");
    CHECK_FALSE(rules.ignores("/p/q/x.tmp", false));
    rules.truncate(size);
    CHECK(rules.ignores("/p/q/x.tmp", false));
}

}  // namespace cobble::driver
