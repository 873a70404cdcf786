// SPDX-License-Identifier: MIT
#include "renderer/scene/rebase.hpp"

#include <cstddef>

#include "ir/math/double_double.hpp"

namespace cobble::renderer {

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
