// SPDX-License-Identifier: MIT
// Where the names of points go, so that none lies on another.
#pragma once

#include <span>
#include <vector>

#include "tools/driver/chart/box.hpp"

namespace cobble::driver::chart {

struct LabelRequest {
    Point point;
    double width = 0;
    double height = 0;
};

struct LabelPlace {
    bool placed = false;  ///< false: there was no room
    Box box;
    bool leader = false;  ///< so far away that a line should lead from the point to the label
    Segment leader_line;
};

/// What labels keep away from.
struct Surroundings {
    Box frame;                   ///< labels stay inside
    std::vector<Box> marks;      ///< labels do not cover them
    std::vector<Segment> lines;  ///< labels cover them only where there is no better place
};

/// One place for each request, in order; the first has the first choice. Labels and marks never
/// overlap; lines are crossed as rarely, and labels as near to their points and no nearer to
/// others, as a greedy choice among places around each point gives. Costs the number of requests
/// times some hundred places times what lies about.
std::vector<LabelPlace> place_labels(std::span<const LabelRequest> requests,
                                     const Surroundings& around);

}  // namespace cobble::driver::chart
