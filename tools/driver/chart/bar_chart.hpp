// SPDX-License-Identifier: MIT
// Shares as horizontal bars, in groups, as an SVG file.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tools/driver/chart/svg.hpp"

namespace cobble::driver::chart {

/// 1 is 100 %. Values that are not finite have no bar.
struct Bar {
    double value = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN();   ///< a whisker from low to high, if
    double high = std::numeric_limits<double>::quiet_NaN();  ///< both are finite
    std::string text;  ///< written at its end: its value, or why there is none
};

struct BarMeasure {
    std::string name;  ///< in the key
    Paint paint = Paint::kBlue;
};

struct BarRow {
    std::string name;
    std::vector<Bar> bars;  ///< one a measure
};

struct BarChart {
    Legend legend;
    std::string axis_title;
    std::vector<BarMeasure> measures;
    std::vector<BarRow> rows;  ///< from the top
    std::vector<std::string> captions;
    std::string empty = "nothing was measured";  ///< written in the middle if there is no row
};

/// The chart, 760 units wide and as high as its rows make it.
std::string draw(const BarChart& chart);

}  // namespace cobble::driver::chart
