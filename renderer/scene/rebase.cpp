// SPDX-License-Identifier: MIT
#include "renderer/scene/rebase.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include "ir/math/double_double.hpp"

namespace cobble::renderer {

math::Vec3d grid_origin(const BoxBounds<double>& box, math::Vec3d anchor) {
    double step = 1024;
    math::Vec3d near = anchor;
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
    math::Vec3d origin;
    for (std::size_t i = 0; i < 3; ++i) origin[i] = std::floor(near[i] / step + 0.5) * step;
    const bool finite = std::fabs(origin.x) <= std::numeric_limits<double>::max() &&
                        std::fabs(origin.y) <= std::numeric_limits<double>::max() &&
                        std::fabs(origin.z) <= std::numeric_limits<double>::max();
    return finite ? origin : math::Vec3d{};
}

math::Affined rebased(const math::Affined& map, math::Vec3d from, math::Vec3d to) {
    using math::DoubleDouble;
    math::Affined result = map;
    for (std::size_t i = 0; i < 3; ++i) {
        DoubleDouble sum(map.rows[i][3]);
        for (std::size_t j = 0; j < 3; ++j) {
            sum += DoubleDouble(map.rows[i][j]) * DoubleDouble(from[j]);
        }
        result.rows[i][3] = static_cast<double>(sum - DoubleDouble(to[i]));
    }
    return result;
}

}  // namespace cobble::renderer
