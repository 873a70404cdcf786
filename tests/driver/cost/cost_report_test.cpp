// SPDX-License-Identifier: MIT
// The faces of a study, as they were looked at: COBBLE_UPDATE=1 writes them anew. charts_test.py
// checks what no golden file says of itself: that it is well-formed, and that no text lies on
// another.
#include "tools/driver/report/cost_report.hpp"

#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "tests/driver/cost/study.hpp"
#include "tests/support/golden.hpp"
#include "tools/driver/report/cost_tables.hpp"
#include "tools/driver/report/html.hpp"
#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

using renderer::CostReport;

std::string expected(std::string_view name) {
    return "tests/driver/cost/expected/" + std::string(name);
}

void check_faces(const CostReport& report, const std::string& name) {
    test::check_golden(expected(name + ".text"), cost_to_text(report, {}));
    test::check_golden(expected(name + ".json"), pretty(cost_to_json(report)));
    test::check_golden(expected(name + ".svg"), cost_to_svg(report));
    test::check_golden(expected(name + "-shares.svg"), cost_shares_to_svg(report));
    test::check_golden(expected(name + ".html"), cost_to_html(report));
}

std::vector<std::string> faces(const CostReport& report) {
    return {cost_to_text(report, {}), dump(cost_to_json(report)), cost_to_svg(report),
            cost_shares_to_svg(report), cost_to_html(report)};
}

bool has(std::string_view text, std::string_view what) {
    return text.find(what) != std::string_view::npos;
}

std::size_t width_of_text(std::string_view text) {
    std::size_t width = 0;
    while (!text.empty()) {
        const CodePoint point = next_code_point(text);
        width += width_of(point.value);
        text.remove_prefix(point.bytes);
    }
    return width;
}

}  // namespace

TEST_CASE("cost: a whole study has the faces that were looked at") {
    check_faces(test::whole_study(), "whole");
}

TEST_CASE("cost: a study cut short says so in each face") {
    const CostReport report = test::cut_short_study();
    check_faces(report, "short");
    const std::string text = cost_to_text(report, {});
    CHECK(has(text, "no choices: the study ended before any was tried"));
    CHECK(has(text, "no slope: "));
    CHECK(has(cost_to_html(report), "No pictures: the study kept none"));
    const Json json = cost_to_json(report);
    CHECK(json["noise"].is_null());
    CHECK(json["precision"].is_null());
    CHECK(json["recommendation"].is_null());
    CHECK(json["curve"]["slope"].is_null());
    CHECK(json["curve"]["points"][1]["band"].is_null());
}

TEST_CASE("cost: numbers without a place on a chart break no face") {
    check_faces(test::study_without_numbers(), "no-numbers");
}

TEST_CASE("cost: a study of nothing has every face") {
    const CostReport nothing;
    for (const std::string& face : faces(nothing)) CHECK(!face.empty());
    CHECK(has(cost_to_svg(nothing), "nothing was measured"));
    CHECK(has(cost_shares_to_svg(nothing), "nothing was measured"));
    CHECK(has(cost_to_text(nothing, {}), "no curve: the study ended before it was measured"));
    CHECK(cost_to_json(nothing)["curve"].is_null());
}

TEST_CASE("cost: one source of noise has nobody to be together with") {
    CostReport report = test::whole_study();
    CHECK(has(cost_to_text(report, {}), "\n  together "));
    CHECK(has(cost_shares_to_svg(report), ">together<"));
    report.noise.shares = {{"pixel", 1, 1, {1, 1}, {1, 1}}};
    report.noise.together = 0;
    const std::string text = cost_to_text(report, {});
    CHECK(!has(text, "\n  together "));
    CHECK(has(text, "all noise is of where in a pixel rays go"));
    CHECK(!has(cost_shares_to_svg(report), ">together<"));
}

TEST_CASE("cost: no face says nan or inf, or claims more than was measured") {
    for (const CostReport& report : {test::whole_study(), test::cut_short_study(),
                                     test::study_without_numbers(), CostReport{}}) {
        for (const std::string& face : faces(report)) {
            CAPTURE(face);
            for (const char* word : {"nan", "inf ", "inf,", "inf\"", "inf<", "onverged"}) {
                CAPTURE(word);
                CHECK(!has(face, word));
            }
        }
    }
}

TEST_CASE("cost: the text fits its columns, and takes no commands from names") {
    for (const unsigned columns : {60U, 100U, 200U}) {
        for (const CostReport& report : {test::whole_study(), test::study_without_numbers()}) {
            std::istringstream lines(cost_to_text(report, {false, columns}));
            for (std::string line; std::getline(lines, line);) {
                CAPTURE(line);
                // Tables are as wide as their numbers; sentences give way.
                CHECK(width_of_text(line) <= 100);
                CHECK(printable(line) == line);
            }
        }
    }
}

TEST_CASE("cost: the page has no way out") {
    const std::string page = cost_to_html(test::whole_study());
    for (const char* word : {"<script", "<link", "@import", "url(", "src=\"http", "href=\"http"}) {
        CAPTURE(word);
        CHECK(!has(page, word));
    }
    // The only address is the name of SVG's vocabulary, which nobody looks up.
    std::size_t addresses = 0;
    for (std::size_t at = 0; (at = page.find("://", at)) != std::string::npos; ++at) ++addresses;
    CHECK(addresses == 2);
}

TEST_CASE("cost: base 64") {
    // RFC 4648, section 10.
    CHECK(base64("").empty());
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foob") == "Zm9vYg==");
    CHECK(base64("fooba") == "Zm9vYmE=");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64("\xFF\xFE\xFD") == "//79");
}

}  // namespace cobble::driver
