// SPDX-License-Identifier: MIT
// Middles of several passes, which one disturbance does not move.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace cobble::bench {

/// The value that `part` (0 to 1) of all are not above, interpolated; 0 if there are none.
inline double quantile(std::vector<double> values, double part) {
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const double at = part * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    const double f = at - static_cast<double>(below);
    return values[below] + f * (values[above] - values[below]);
}

/// Of the values in any order: the middle, or the mean of the two that are.
inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

/// How many times as fast as `other`: the median over passes of the two neighbours' ratio. 0 if
/// there are none.
inline double speed_ratio(const std::vector<double>& seconds, const std::vector<double>& other) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(seconds.size(), other.size()); ++i) {
        ratios.push_back(other[i] / seconds[i]);
    }
    return median(std::move(ratios));
}

}  // namespace cobble::bench
