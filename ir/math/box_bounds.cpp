// SPDX-License-Identifier: MIT
#include "ir/math/box_bounds.hpp"

#include <cmath>

namespace cobble::math {

Vec3d grid_origin(const BoxBounds<double>& box, Vec3d anchor) {
    double step = 1024;
    Vec3d near = anchor;
    if (!box.empty()) {
        double side = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double d = box.hi[i] - box.lo[i];
            side = d > side ? d : side;
            near[i] = anchor[i] < box.lo[i] ? box.lo[i] : anchor[i];
            near[i] = near[i] > box.hi[i] ? box.hi[i] : near[i];
        }
        // Doublings and halvings are exact; some two thousand of them at the very most.
        step = 1;
        if (!(side <= std::numeric_limits<double>::max() / 4)) return {};
        while (step < side) step *= 2;
        while (side > 0 && step * 0.5 >= side) step *= 0.5;
    }
    Vec3d origin;
    for (std::size_t i = 0; i < 3; ++i) origin[i] = std::floor(near[i] / step + 0.5) * step;
    return finite(origin) ? origin : Vec3d{};
}

}  // namespace cobble::math
