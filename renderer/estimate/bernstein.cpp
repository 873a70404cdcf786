// SPDX-License-Identifier: MIT
#include "renderer/estimate/bernstein.hpp"

#include <cmath>

#include "ir/math/elementary.hpp"

namespace cobble::renderer {

double bernstein_half_width(double variance, std::uint32_t count, double miss) {
    const double n = count;
    const double surprise = math::log(4 / miss);
    return std::sqrt(2 * variance * surprise / n) + 7 * surprise / (3 * (n - 1));
}

std::uint32_t bernstein_fewest(double error, double miss) {
    std::uint32_t count = 2;
    while (count < (1U << 31U) && bernstein_half_width(0, count, miss) > error) count *= 2;
    return count;
}

}  // namespace cobble::renderer
