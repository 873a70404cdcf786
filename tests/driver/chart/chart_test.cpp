// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "tests/support/golden.hpp"
#include "tests/support/split_mix.hpp"
#include "tools/driver/chart/bar_chart.hpp"
#include "tools/driver/chart/curve_chart.hpp"
#include "tools/driver/chart/labels.hpp"
#include "tools/driver/chart/scale.hpp"

namespace cobble::driver::chart {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// In [0, 1).
double unit(test::SplitMix64& random) {
    return static_cast<double>(random.bits() >> 11U) * 0x1p-53;
}

std::string labels_of(const std::vector<Tick>& ticks) {
    std::string text;
    for (const Tick& tick : ticks) {
        if (!tick.label.empty()) text += (text.empty() ? "" : " | ") + tick.label;
    }
    return text;
}

std::string log_labels(double low, double high) {
    const std::array values{low, high};
    return labels_of(LogScale(values).ticks());
}

std::string share_labels(double low, double high) {
    const std::array values{low, high};
    return labels_of(ShareScale(values).ticks());
}

bool has(std::string_view text, std::string_view what) {
    return text.find(what) != std::string_view::npos;
}

CurveChart crowded() {
    CurveChart chart;
    chart.legend = {"crowded", "Twenty names in one corner", "a test"};
    chart.x_title = "time (seconds)";
    chart.y_title = "error";
    Series series;
    series.name = "points";
    series.band_name = "band";
    for (int i = 0; i < 20; ++i) {
        const double x = 1 + 0.01 * i;
        series.points.push_back({x, 2 - 0.02 * i, 1, 3, "name " + std::to_string(i), "tip"});
    }
    series.points.push_back({1000, 0.001, kNaN, kNaN, "far away", ""});
    chart.series.push_back(series);
    return chart;
}

}  // namespace

TEST_CASE("chart: coordinates are the same everywhere") {
    CHECK(coordinate(0) == "0");
    CHECK(coordinate(-0.0) == "0");
    CHECK(coordinate(-0.001) == "0");
    CHECK(coordinate(1.5) == "1.5");
    CHECK(coordinate(100) == "100");
    CHECK(coordinate(-2.675) == "-2.67");
    CHECK(coordinate(1e6 / 3) == "333333.33");
    CHECK(coordinate(kNaN) == "0");
    CHECK(coordinate(-kInfinity) == "0");
}

TEST_CASE("chart: what XML has signs for is escaped, and controls are made visible") {
    CHECK(escape_xml("a<b>&\"c\"'") == "a&lt;b&gt;&amp;&quot;c&quot;&#39;");
    CHECK(escape_xml("\x1b[31m\xFF") == "\xEF\xBF\xBD[31m\xEF\xBF\xBD");
}

TEST_CASE("chart: sentences are broken at spaces") {
    const auto lines = wrap("one  two  three", text_width("one two", 12), 12);
    REQUIRE(lines.size() == 2);
    CHECK(lines[0] == "one two");
    CHECK(lines[1] == "three");
    CHECK(fit("four", text_width("four", 12), 12) == "four");
    CHECK(fit("four", text_width("four", 12) - 1, 12) == "f…");
    CHECK(fit("四四", text_width("four", 12), 12) == "…");
    CHECK(fit("four", 0, 12) == "…");
    CHECK(wrap("unbreakable", 1, 12).size() == 1);
    CHECK(wrap("", 100, 12).empty());
}

TEST_CASE("chart: logarithmic axes label decades, and digits between where these are few") {
    CHECK(log_labels(0.001, 100) == "0.001 | 0.01 | 0.1 | 1 | 10 | 100");
    CHECK(log_labels(0.01, 1) == "0.01 | 0.02 | 0.05 | 0.1 | 0.2 | 0.5 | 1");
    CHECK(log_labels(0.02, 0.04) == "0.01 | 0.02 | 0.05 | 0.1");
    CHECK(log_labels(1e-9, 1e-5) == "10⁻⁹ | 10⁻⁸ | 10⁻⁷ | 10⁻⁶ | 10⁻⁵");
    CHECK(log_labels(3e-7, 4e-7) == "10⁻⁷ | 2×10⁻⁷ | 5×10⁻⁷ | 10⁻⁶");
    CHECK(log_labels(1e5, 1e8) == "100000 | 10⁶ | 10⁷ | 10⁸");
    CHECK(log_labels(1e-300, 1e300) == "10⁻²⁵⁵ | 10⁻¹⁷⁰ | 10⁻⁸⁵ | 1 | 10⁸⁵ | 10¹⁷⁰ | 10²⁵⁵");
    CHECK(!log_labels(5e-324, 5e-324).empty());
    CHECK(!log_labels(std::numeric_limits<double>::max(), 1e308).empty());
    CHECK(log_labels(0, kNaN) == "0.1 | 0.2 | 0.5 | 1");
}

TEST_CASE("chart: logarithmic axes hold what they are made for, in order") {
    test::SplitMix64 random(7);
    for (int i = 0; i < 1000; ++i) {
        const double one = std::pow(10, unit(random) * 600 - 300);
        const double other = std::pow(10, unit(random) * 600 - 300);
        const std::array values{one, other};
        const LogScale scale(values);
        const double a = scale.unit(values[0]);
        const double b = scale.unit(values[1]);
        CHECK(a > 0);
        CHECK(a < 1);
        CHECK((values[0] < values[1]) == (a < b));
        const auto ticks = scale.ticks();
        CHECK(ticks.size() < 100);
        CHECK(!labels_of(ticks).empty());
        for (const Tick& tick : ticks) {
            CHECK(tick.unit >= 0);
            CHECK(tick.unit <= 1);
        }
    }
    const std::array values{1.0, 10.0};
    CHECK(LogScale(values).unit(0) == 0);
    CHECK(LogScale(values).unit(-1) == 0);
    CHECK(LogScale(values).unit(kNaN) == 0);
    CHECK(LogScale(values).unit(kInfinity) == 1);
}

TEST_CASE("chart: axes of shares hold zero, and end at a tick") {
    CHECK(share_labels(0.1, 0.43) == "0 % | 10 % | 20 % | 30 % | 40 % | 50 %");
    CHECK(share_labels(-0.12, 0.351) == "-10 % | 0 % | 10 % | 20 % | 30 % | 40 %");
    CHECK(share_labels(-0.002, 0.351) == share_labels(0, 0.351));
    CHECK(share_labels(0, 1) == "0 % | 20 % | 40 % | 60 % | 80 % | 100 %");
    CHECK(share_labels(0, 0) == "0.0 % | 0.2 % | 0.4 % | 0.6 % | 0.8 % | 1.0 %");
    CHECK(share_labels(kNaN, 1e300) == share_labels(0, 0));
    const std::array values{-0.5, 0.5};
    CHECK(ShareScale(values).unit(kNaN) == ShareScale(values).unit(0));
}

TEST_CASE("chart: labels lie on no mark, no label, and inside") {
    test::SplitMix64 random(11);
    std::size_t placed = 0;
    std::size_t asked = 0;
    for (int round = 0; round < 200; ++round) {
        Surroundings around{{0, 0, 660, 340}, {}, {}};
        std::vector<LabelRequest> requests;
        const auto count = 1 + static_cast<std::size_t>(unit(random) * 25);
        // From spread out to one heap.
        const double spread = unit(random);
        for (std::size_t i = 0; i < count; ++i) {
            const double x = 330 + (unit(random) - 0.5) * spread * 640;
            const double y = 170 + (unit(random) - 0.5) * spread * 330;
            const double width = 10 + unit(random) * 100;
            requests.push_back({{x, y}, width, 14});
            around.marks.push_back({x - 5, y - 5, x + 5, y + 5});
            if (i > 0) around.lines.push_back({requests[i - 1].point, requests[i].point});
        }
        const auto places = place_labels(requests, around);
        REQUIRE(places.size() == count);
        asked += count;
        for (std::size_t i = 0; i < count; ++i) {
            if (!places[i].placed) continue;
            ++placed;
            const Box& box = places[i].box;
            CHECK(inside(box, around.frame));
            CHECK(std::abs(box.x1 - box.x0 - requests[i].width) < 1e-9);
            for (const Box& mark : around.marks) CHECK(!overlap(mark, box));
            for (std::size_t k = 0; k < count; ++k) {
                if (k == i || !places[k].placed) continue;
                CHECK(!overlap(places[k].box, box));
                if (places[k].leader) CHECK(!meets(places[k].leader_line, box));
            }
        }
    }
    // Where there is room it is found: nearly all of them have some.
    CHECK(placed > asked * 9 / 10);
}

TEST_CASE("chart: a label beside a point alone is to its right") {
    const std::array requests{LabelRequest{{100, 100}, 40, 14}};
    const Surroundings around{{0, 0, 400, 300}, {{95, 95, 105, 105}}, {}};
    const auto places = place_labels(requests, around);
    CHECK(places[0].placed);
    CHECK(!places[0].leader);
    CHECK(places[0].box.x0 == 108);
    CHECK(places[0].box.y0 == 93);
    // Without room there is none.
    const Surroundings narrow{{0, 0, 30, 300}, {}, {}};
    CHECK(!place_labels(requests, narrow)[0].placed);
}

TEST_CASE("chart: a label is no nearer to another point than to its own") {
    // To the right there is room, but beside the other point.
    const std::array requests{LabelRequest{{100, 100}, 40, 14}};
    const Surroundings around{{0, 0, 400, 300}, {{95, 95, 105, 105}, {149, 95, 159, 105}}, {}};
    const auto places = place_labels(requests, around);
    REQUIRE(places[0].placed);
    CHECK(places[0].box.x1 < 140);
}

TEST_CASE("chart: segments and boxes") {
    const Box box{0, 0, 10, 10};
    CHECK(meets({{-5, 5}, {15, 5}}, box));
    CHECK(meets({{5, 5}, {6, 6}}, box));
    CHECK(meets({{5, -5}, {5, 5}}, box));
    CHECK(!meets({{-5, 5}, {-1, 5}}, box));
    CHECK(!meets({{11, -5}, {11, 15}}, box));
    CHECK(!meets({{-5, 8}, {3, 16}}, box));
    CHECK(meets({{-5, 4}, {5, 14}}, box));
}

TEST_CASE("chart: crowded names do not collide") {
    test::check_golden("tests/driver/chart/expected/crowded.svg", draw(crowded()));
}

TEST_CASE("chart: what has no place is counted, and breaks nothing") {
    CurveChart chart = crowded();
    Series odd;
    odd.name = "odd & <rest>";
    odd.band_name = "odd band";
    odd.mark = Mark::kHollowDiamond;
    odd.points = {{0, 1, 1, 1, "zero", ""},         {1, -1, 1, 1, "below", ""},
                  {kNaN, 1, 1, 1, "nan", ""},       {1, kInfinity, 1, 1, "inf", ""},
                  {10, 0.1, 0, kInfinity, "a", ""}, {20, 0.1, kNaN, 1, "b", ""},
                  {30, 0.1, -1, 1e300, "c", ""},    {1e6, 1e-6, 1e-30, 1, "d", ""}};
    chart.series.push_back(odd);
    const std::string svg = draw(chart);
    CHECK(has(svg, "what was not measured: 4 points.<"));
    CHECK(has(svg, "odd &amp; &lt;rest&gt;"));
    CHECK(!has(svg, ">zero<"));
    CHECK(!has(svg, "nan"));
    test::check_golden("tests/driver/chart/expected/odd.svg", svg);
}

TEST_CASE("chart: bars of every kind") {
    BarChart chart;
    chart.legend = {"bars", "Shares", "a test"};
    chart.axis_title = "share (per cent)";
    chart.measures = {{"of the time", Paint::kBlue}, {"of the noise", Paint::kVermilion}};
    chart.rows = {
        {"plain", {{0.25, kNaN, kNaN, "25 %"}, {0.4, 0.3, 0.5, "40 %"}}},
        {"below nothing", {{-0.1, -0.2, 0.05, "-10 %"}, {0, 0, 0, "0 %"}}},
        {"not there", {{kNaN, kNaN, kNaN, "not measured"}, {0.1, kInfinity, 0.2, "10 %"}}},
        {"too much", {{kInfinity, 1, 2, "infinite"}, {0.3, 0.2, kInfinity, "30 %"}}},
        {"a name that goes on for longer than anybody would like", {}}};
    chart.captions = {"caption"};
    test::check_golden("tests/driver/chart/expected/bars.svg", draw(chart));
    chart.rows.clear();
    CHECK(has(draw(chart), "nothing was measured"));
}

}  // namespace cobble::driver::chart
