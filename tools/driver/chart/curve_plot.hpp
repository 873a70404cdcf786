// SPDX-License-Identifier: MIT
// Where things of a curve chart lie, before anything is drawn. Private to this folder.
#pragma once

#include <string_view>
#include <vector>

#include "tools/driver/chart/curve_chart.hpp"
#include "tools/driver/chart/labels.hpp"
#include "tools/driver/chart/scale.hpp"

namespace cobble::driver::chart {

/// A name and its place, where there is room.
struct PlacedName {
    std::string_view text;
    Point point;
    LabelPlace place;
};

class CurvePlot {
  public:
    /// `top` is where the plot begins. The chart must outlive it.
    CurvePlot(const CurveChart& chart, double top);

    [[nodiscard]] const Box& box() const { return box_; }
    [[nodiscard]] const LogScale& x() const { return x_; }
    [[nodiscard]] const LogScale& y() const { return y_; }
    [[nodiscard]] double x_at(double unit) const { return box_.x0 + unit * (box_.x1 - box_.x0); }
    [[nodiscard]] double y_at(double unit) const { return box_.y1 - unit * (box_.y1 - box_.y0); }
    [[nodiscard]] Point place(double x, double y) const {
        return {x_at(x_.unit(x)), y_at(y_.unit(y))};
    }

    /// Where the points of the series lie that have a place, in order.
    [[nodiscard]] std::vector<Point> places(const Series& series) const;

    /// All names of points that have a place, the last series first.
    [[nodiscard]] const std::vector<PlacedName>& names() const { return names_; }

  private:
    [[nodiscard]] Surroundings surroundings(const CurveChart& chart) const;
    void place_names(const CurveChart& chart);

    Box box_;
    LogScale x_, y_;
    std::vector<PlacedName> names_;
};

/// True if logarithmic axes have a place for it.
bool has_place(const CurvePoint& point);

/// True if one of its points has a place.
bool has_place(const Series& series);

/// The size of names beside points.
inline constexpr double kNameSize = 11;

}  // namespace cobble::driver::chart
