// SPDX-License-Identifier: MIT
#include "ir/math/box_bounds.hpp"

#include <cmath>

namespace cobble::math {

double grid_step(const BoxBounds<double>& box) {
    if (box.empty()) return 1024;
    double side = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double d = box.hi[i] - box.lo[i];
        side = d > side ? d : side;
    }
    if (!(side <= std::numeric_limits<double>::max() / 4)) {
        return std::numeric_limits<double>::infinity();
    }
    // Doublings and halvings are exact; some two thousand of them at the very most.
    double step = 1;
    while (step < side) step *= 2;
    while (side > 0 && step * 0.5 >= side) step *= 0.5;
    return step;
}

Vec3d nearest_on_grid(Vec3d p, double step) {
    Vec3d origin;
    for (std::size_t i = 0; i < 3; ++i) origin[i] = std::floor(p[i] / step + 0.5) * step;
    return finite(origin) ? origin : Vec3d{};
}

Vec3d grid_origin(const BoxBounds<double>& box, Vec3d anchor) {
    Vec3d near = anchor;
    for (std::size_t i = 0; i < 3 && !box.empty(); ++i) {
        near[i] = anchor[i] < box.lo[i] ? box.lo[i] : anchor[i];
        near[i] = near[i] > box.hi[i] ? box.hi[i] : near[i];
    }
    return nearest_on_grid(near, grid_step(box));
}

}  // namespace cobble::math
