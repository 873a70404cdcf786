// SPDX-License-Identifier: MIT
#include "renderer/estimate/jackknife.hpp"

#include <cmath>
#include <cstdint>

#include "renderer/estimate/student.hpp"

namespace cobble::renderer {

double jackknife_reach(const std::vector<double>& left_out) {
    constexpr double kTails = 0.05;
    const auto n = static_cast<double>(left_out.size());
    double mean = 0;
    for (const double one : left_out) mean += one / n;
    double squares = 0;
    for (const double one : left_out) squares += (one - mean) * (one - mean);
    const auto degrees = static_cast<std::uint32_t>(left_out.size() - 1);
    return student_quantile(kTails, degrees) * std::sqrt((n - 1) / n * squares);
}

}  // namespace cobble::renderer
