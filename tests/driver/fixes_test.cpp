// SPDX-License-Identifier: MIT
#include "tools/driver/fixes.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace cobble::driver {
namespace {

const source::DiagnosticCode kCode("test-fix", source::Severity::kError, "a finding", "why", "x",
                                   "mend");
constexpr source::SourceId kScene{0};

source::Diagnostic fixed_by(std::vector<source::Edit> edits, bool safe = true,
                            std::uint32_t at = 0) {
    source::Diagnostic result;
    result.code = &kCode;
    result.span = {kScene, at, at};
    result.fixes = {{"do it", safe, std::move(edits)}};
    return result;
}

std::string applied(const std::vector<source::Diagnostic>& findings, bool unsafe,
                    std::size_t expected_count) {
    std::size_t count = 0;
    std::string text = apply_fixes("0123456789", kScene, findings, unsafe, count);
    CHECK(count == expected_count);
    return text;
}

source::Edit edit(std::uint32_t begin, std::uint32_t end, std::string text) {
    return {{kScene, begin, end}, std::move(text)};
}

}  // namespace

TEST_CASE("fixes apart from each other are all applied") {
    CHECK(applied({fixed_by({edit(1, 2, "A")}), fixed_by({edit(4, 6, "")}),
                   fixed_by({edit(9, 9, "B"), edit(7, 8, "C")})},
                  false, 3) == "0A236C8B9");
}

TEST_CASE("of two that overlap the first is applied") {
    CHECK(applied({fixed_by({edit(1, 4, "A")}), fixed_by({edit(3, 5, "B")})}, false, 1) ==
          "0A456789");
    CHECK(applied({fixed_by({edit(1, 1, "A")}), fixed_by({edit(1, 1, "B")})}, false, 1) ==
          "0A123456789");
    CHECK(applied({fixed_by({edit(6, 8, "A")}), fixed_by({edit(0, 1, ""), edit(7, 9, "B")})}, false,
                  1) == "012345A89");
}

TEST_CASE("neighbours do not overlap") {
    CHECK(applied({fixed_by({edit(1, 4, "A")}), fixed_by({edit(4, 5, "B")})}, false, 2) ==
          "0AB56789");
}

TEST_CASE("an unsafe fix waits to be asked for") {
    CHECK(applied({fixed_by({edit(1, 4, "A")}, false)}, false, 0) == "0123456789");
    CHECK(applied({fixed_by({edit(1, 4, "A")}, false)}, true, 1) == "0A456789");
}

TEST_CASE("a fix in another file is not applied") {
    source::Diagnostic finding = fixed_by({edit(1, 4, "A")});
    finding.fixes[0].edits[0].span.source = source::SourceId{1};
    CHECK(applied({finding}, true, 0) == "0123456789");
}

}  // namespace cobble::driver
