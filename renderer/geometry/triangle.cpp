// SPDX-License-Identifier: MIT
#include "renderer/geometry/triangle.hpp"

namespace cobble::renderer::detail {

double common_scale(const std::array<ShearedPoint<double>, 3>& points) {
    double most = 0;
    for (const auto& p : points) {
        if (std::fabs(p.x) > most) most = std::fabs(p.x);
        if (std::fabs(p.y) > most) most = std::fabs(p.y);
    }
    // To around 1; two steps reach every exponent.
    double scale = 1;
    if (most > 0x1p400) scale = 0x1p-600;
    if (most < 0x1p-300 && most > 0) scale = 0x1p600;
    return scale;
}

}  // namespace cobble::renderer::detail
