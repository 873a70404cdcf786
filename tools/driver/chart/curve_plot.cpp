// SPDX-License-Identifier: MIT
#include "tools/driver/chart/curve_plot.hpp"

#include <algorithm>

#include "tools/driver/chart/layout.hpp"

namespace cobble::driver::chart {
namespace {

constexpr double kPlotHeight = 340;
// Room for "0.0001" and the title of the axis.
constexpr double kPlotLeft = 84;
constexpr double kNameHeight = 14;
// Ends of bands stretch the axis to so many times the extreme values at most.
constexpr double kBandReach = 10;

std::vector<double> x_values(const CurveChart& chart) {
    std::vector<double> values;
    for (const Series& series : chart.series) {
        for (const CurvePoint& point : series.points) {
            if (has_place(point)) values.push_back(point.x);
        }
    }
    return values;
}

// A band may reach down to nothing, where a logarithmic axis has no end.
std::vector<double> y_values(const CurveChart& chart) {
    std::vector<double> values;
    double low = 0;
    double high = 0;
    for (const Series& series : chart.series) {
        for (const CurvePoint& point : series.points) {
            if (!has_place(point)) continue;
            low = values.empty() ? point.y : std::min(low, point.y);
            high = values.empty() ? point.y : std::max(high, point.y);
            values.push_back(point.y);
        }
    }
    for (const Series& series : chart.series) {
        if (series.band_name.empty()) continue;
        for (const CurvePoint& point : series.points) {
            if (!has_place(point)) continue;
            if (point.low > low / kBandReach && point.low < low) values.push_back(point.low);
            if (point.high > high && point.high < high * kBandReach) values.push_back(point.high);
        }
    }
    return values;
}

}  // namespace

bool has_place(const CurvePoint& point) { return has_place(point.x) && has_place(point.y); }

bool has_place(const Series& series) {
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const CurvePoint& point) { return has_place(point); });
}

CurvePlot::CurvePlot(const CurveChart& chart, double top)
    : box_{kPlotLeft, top, kChartWidth - kMargin, top + kPlotHeight},
      x_(x_values(chart)),
      y_(y_values(chart)) {
    place_names(chart);
}

std::vector<Point> CurvePlot::places(const Series& series) const {
    std::vector<Point> points;
    for (const CurvePoint& point : series.points) {
        if (has_place(point)) points.push_back(place(point.x, point.y));
    }
    return points;
}

Surroundings CurvePlot::surroundings(const CurveChart& chart) const {
    Surroundings around{box_, {}, {}};
    for (const Series& series : chart.series) {
        const std::vector<Point> points = places(series);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point& p = points[i];
            if (series.mark != Mark::kNone) {
                around.marks.push_back(
                    {p.x - kMarkRadius, p.y - kMarkRadius, p.x + kMarkRadius, p.y + kMarkRadius});
            }
            if (series.line && i > 0) around.lines.push_back({points[i - 1], p});
        }
    }
    return around;
}

void CurvePlot::place_names(const CurveChart& chart) {
    std::vector<LabelRequest> requests;
    for (auto series = chart.series.rbegin(); series != chart.series.rend(); ++series) {
        for (const CurvePoint& point : series->points) {
            if (point.name.empty() || !has_place(point)) continue;
            const Point at = place(point.x, point.y);
            requests.push_back({at, text_width(point.name, kNameSize), kNameHeight});
            names_.push_back({point.name, at, {}});
        }
    }
    const std::vector<LabelPlace> found = place_labels(requests, surroundings(chart));
    for (std::size_t i = 0; i < found.size(); ++i) names_[i].place = found[i];
}

}  // namespace cobble::driver::chart
