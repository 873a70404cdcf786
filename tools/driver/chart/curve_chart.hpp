// SPDX-License-Identifier: MIT
// Curves and points over two logarithmic axes, as an SVG file.
#pragma once

#include <string>
#include <vector>

#include "tools/driver/chart/svg.hpp"

namespace cobble::driver::chart {

/// Points whose x or y is not a number above 0 have no place on logarithmic axes: they are left out
/// and counted in a line below.
struct CurvePoint {
    double x = 0, y = 0;
    double low = 0, high = 0;  ///< the band around y, if its series has one; NaN: none here
    std::string name;          ///< written beside it if there is room; may be empty
    std::string tip;           ///< shown by viewers that are pointed at it; may be empty
};

struct Series {
    std::string name;                ///< in the key
    std::vector<CurvePoint> points;  ///< in the order of their line
    Paint paint = Paint::kBlue;
    Mark mark = Mark::kDot;
    bool line = true;
    Dash dash = Dash::kSolid;
    std::string band_name;  ///< of the shade between low and high, in the key; empty: no band
};

struct CurveChart {
    Legend legend;
    std::string x_title, y_title;       ///< with their units
    std::vector<Series> series;         ///< the first lies lowest and has the last choice of labels
    std::vector<std::string> captions;  ///< below; each is broken into lines as needed
    std::string empty = "nothing was measured";  ///< written in the middle if there is no point
};

/// The chart, 760 units wide. Costs some microseconds a point.
std::string draw(const CurveChart& chart);

}  // namespace cobble::driver::chart
