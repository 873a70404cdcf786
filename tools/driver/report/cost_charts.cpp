// SPDX-License-Identifier: MIT
// A study of cost as charts.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tools/driver/chart/bar_chart.hpp"
#include "tools/driver/chart/curve_chart.hpp"
#include "tools/driver/report/cost_report.hpp"
#include "tools/driver/report/cost_tables.hpp"
#include "tools/driver/report/figures.hpp"
#include "tools/driver/text.hpp"

namespace cobble::driver {
namespace {

using chart::Paint;
using renderer::CostReport;

std::string tip_of(const std::string& name, double seconds, double error) {
    return fmt::format("{}: {} s, error {}", name, figure(seconds), figure(error));
}

// The measured times, and errors that fall as those of independent samples do.
chart::Series independent(const renderer::ErrorCurve& curve) {
    chart::Series series;
    series.name = "if samples were independent";
    series.paint = Paint::kGrey;
    series.mark = chart::Mark::kNone;
    series.dash = chart::Dash::kDotted;
    const renderer::CurvePoint* first = nullptr;
    for (const renderer::CurvePoint& point : curve.points) {
        if (!(point.error > 0) || !(point.seconds > 0) || point.samples == 0) continue;
        if (first == nullptr) first = &point;
        const double ratio = static_cast<double>(first->samples) / point.samples;
        chart::CurvePoint at;
        at.x = point.seconds;
        at.y = first->error * std::sqrt(ratio);
        series.points.push_back(std::move(at));
    }
    return series;
}

chart::Series measured(const renderer::ErrorCurve& curve) {
    chart::Series series;
    series.name = "noise of so many samples a pixel";
    series.paint = Paint::kBlue;
    series.band_name = "its 95 % interval";
    for (const renderer::CurvePoint& point : curve.points) {
        series.points.push_back(
            {point.seconds, point.error, point.band.low, point.band.high,
             std::to_string(point.samples),
             tip_of(counted(point.samples, "sample"), point.seconds, point.error)});
    }
    return series;
}

chart::CurvePoint point_of(const renderer::Rung& rung, bool named) {
    const std::string tip =
        fmt::format("{}, at most {}, {}", tip_of(rung_name(rung), rung.seconds, rung.error),
                    counted(rung.bounces, "bounce"), precision_name(rung.precision));
    return {rung.seconds,
            rung.error,
            renderer::kNotMeasured,
            renderer::kNotMeasured,
            named ? rung_name(rung) : "",
            tip};
}

// The choices that `take` takes, by time, so that a line can join them.
template <typename Take>
chart::Series choices(const CostReport& report, bool named, Take take) {
    std::vector<const renderer::Rung*> rungs;
    for (const renderer::Rung& rung : report.rungs) {
        if (take(rung)) rungs.push_back(&rung);
    }
    std::stable_sort(rungs.begin(), rungs.end(), [](const auto* a, const auto* b) {
        // What was not measured comes last; it has no place on the chart.
        return std::isnan(b->seconds) ? !std::isnan(a->seconds) : a->seconds < b->seconds;
    });
    chart::Series series;
    series.paint = Paint::kVermilion;
    series.line = false;
    for (const renderer::Rung* rung : rungs) series.points.push_back(point_of(*rung, named));
    return series;
}

std::vector<chart::Series> series_of(const CostReport& report) {
    std::vector<chart::Series> all;
    if (!report.curve.points.empty()) {
        if (report.curve.points.size() > 1) all.push_back(independent(report.curve));
        all.push_back(measured(report.curve));
    }
    const auto add = [&all](chart::Series series, std::string_view name, chart::Mark mark) {
        if (series.points.empty()) return;
        series.name = name;
        series.mark = mark;
        all.push_back(std::move(series));
    };
    chart::Series others =
        choices(report, false, [](const renderer::Rung& rung) { return !rung.on_front; });
    others.paint = Paint::kGrey;
    add(std::move(others), "other choices, beaten in both", chart::Mark::kRing);
    chart::Series front =
        choices(report, false, [](const renderer::Rung& rung) { return rung.on_front; });
    if (front.points.size() > 1) {
        for (chart::CurvePoint& point : front.points) point.tip.clear();
        front.line = true;
        front.dash = chart::Dash::kDashed;
        add(std::move(front), "the front: nothing is better in both", chart::Mark::kNone);
    }
    add(choices(report, true,
                [](const renderer::Rung& rung) { return rung.on_front && !rung.verified; }),
        "on the front, run once", chart::Mark::kHollowDiamond);
    add(choices(report, true,
                [](const renderer::Rung& rung) { return rung.on_front && rung.verified; }),
        "on the front, verified", chart::Mark::kDiamond);
    return all;
}

std::string description_of(const CostReport& report) {
    const auto& points = report.curve.points;
    std::string text;
    if (points.empty()) {
        text = "No curve was measured.";
    } else {
        text = fmt::format("The noise falls from {} after {} s ({}) to {} after {} s ({}).",
                           figure(points.front().error), figure(points.front().seconds),
                           counted(points.front().samples, "sample"), figure(points.back().error),
                           figure(points.back().seconds), counted(points.back().samples, "sample"));
    }
    for (const renderer::Rung& rung : report.rungs) {
        if (!rung.on_front) continue;
        text += fmt::format(" {}.", tip_of(rung_name(rung), rung.seconds, rung.error));
    }
    return text;
}

// The rows of both bills, in the order of the effects' bill, then what is noise alone.
std::vector<std::string> share_names(const CostReport& report) {
    std::vector<std::string> names;
    for (const renderer::EffectBill& bill : report.effects) {
        names.emplace_back(ir::name_of(bill.effect));
    }
    for (const renderer::NoiseShare& share : report.noise.shares) {
        if (std::find(names.begin(), names.end(), share.name) == names.end()) {
            names.push_back(share.name);
        }
    }
    return names;
}

chart::Bar bar_of(double value, const renderer::Interval& band) {
    return {value, band.low, band.high,
            std::isfinite(value) ? percent(value) : std::string("not measured")};
}

chart::Bar time_bar(const CostReport& report, std::string_view name) {
    for (const renderer::EffectBill& bill : report.effects) {
        if (ir::name_of(bill.effect) == name) return bar_of(bill.share, {});
    }
    return {};
}

chart::Bar noise_bar(const CostReport& report, std::string_view name) {
    for (const renderer::NoiseShare& share : report.noise.shares) {
        if (share.name == name) return bar_of(share.first, share.first_band);
    }
    return {};
}

}  // namespace

std::string cost_to_svg(const CostReport& report) {
    chart::CurveChart drawing;
    drawing.legend = {"error-over-time", "What accuracy costs in time", description_of(report)};
    drawing.x_title = "time to render the picture (seconds, with its preparation)";
    drawing.y_title = "error (RMSE, 1 is black to white)";
    drawing.series = series_of(report);
    if (!drawing.series.empty()) {
        drawing.empty = "no number that logarithmic axes have a place for";
    }
    drawing.captions.push_back(cost_subject(report));
    if (!report.curve.points.empty()) {
        drawing.captions.push_back(fmt::format(
            "Numbers at the curve are samples a pixel. The curve is noise alone, by {} of each; "
            "choices are measured from the best picture of the study, bias included.",
            counted(report.curve.replicates, "independent picture")));
    }
    return draw(drawing);
}

std::string cost_shares_to_svg(const CostReport& report) {
    chart::BarChart drawing;
    drawing.legend = {"shares", "What each effect takes", ""};
    drawing.axis_title = "share (per cent)";
    drawing.measures.push_back({"of the time", Paint::kBlue});
    const bool noise = !report.noise.shares.empty();
    if (noise) {
        drawing.measures.push_back(
            {"of the noise, alone, with its 95 % interval", Paint::kVermilion});
    }
    const auto add = [&](const std::string& name, chart::Bar time, chart::Bar share) {
        std::string said;
        if (!time.text.empty()) said += fmt::format(" {} of the time", time.text);
        if (!share.text.empty()) {
            said += fmt::format("{} {} of the noise", said.empty() ? "" : ",", share.text);
        }
        drawing.legend.description += fmt::format(
            "{}{}:{}.", drawing.legend.description.empty() ? "" : " ", printable(name), said);
        chart::BarRow row{printable(name), {std::move(time)}};
        if (noise) row.bars.push_back(std::move(share));
        drawing.rows.push_back(std::move(row));
    };
    for (const std::string& name : share_names(report)) {
        chart::Bar time = time_bar(report, name);
        add(name, std::move(time), noise_bar(report, name));
    }
    const bool several = report.noise.shares.size() > 1;
    if (several) add("together", {}, bar_of(report.noise.together, report.noise.together_band));
    if (drawing.rows.empty()) drawing.legend.description = "Nothing was measured.";
    drawing.captions.push_back(cost_subject(report));
    if (noise) {
        drawing.captions.push_back(fmt::format(
            "Noise: of the variance of a picture of {} a pixel{}.",
            counted(report.noise.samples, "sample"),
            several ? "; what several sources make only together is a row of its own" : ""));
    }
    return draw(drawing);
}

}  // namespace cobble::driver
