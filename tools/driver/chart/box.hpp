// SPDX-License-Identifier: MIT
// Places on a chart, in units of its viewBox: x to the right, y downwards.
#pragma once

namespace cobble::driver::chart {

struct Point {
    double x = 0;
    double y = 0;
};

struct Segment {
    Point from, to;
};

/// x0 <= x1, y0 <= y1.
struct Box {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// True if they share more than an edge.
constexpr bool overlap(const Box& a, const Box& b) {
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

constexpr bool inside(const Box& inner, const Box& outer) {
    return inner.x0 >= outer.x0 && inner.x1 <= outer.x1 && inner.y0 >= outer.y0 &&
           inner.y1 <= outer.y1;
}

/// True if a part of the segment lies in the box (Liang and Barsky's clipping, CGIP 3(1), 1984).
constexpr bool meets(const Segment& segment, const Box& box) {
    const double dx = segment.to.x - segment.from.x;
    const double dy = segment.to.y - segment.from.y;
    // The box is where p t <= q for all four, with t from 0 to 1 along the segment.
    const double p[] = {-dx, dx, -dy, dy};
    const double q[] = {segment.from.x - box.x0, box.x1 - segment.from.x, segment.from.y - box.y0,
                        box.y1 - segment.from.y};
    double enters = 0;
    double leaves = 1;
    for (int i = 0; i < 4; ++i) {
        if (p[i] == 0 && q[i] < 0) return false;
        if (p[i] == 0) continue;
        const double t = q[i] / p[i];
        if (p[i] < 0 && t > enters) enters = t;
        if (p[i] > 0 && t < leaves) leaves = t;
    }
    return enters <= leaves;
}

}  // namespace cobble::driver::chart
