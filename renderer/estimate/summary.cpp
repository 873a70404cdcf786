// SPDX-License-Identifier: MIT
#include "renderer/estimate/summary.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "renderer/estimate/pixel_error.hpp"
#include "renderer/estimate/student.hpp"

namespace cobble::renderer {
namespace {

constexpr double kTails = 0.05;

/// The value that 99 % do not exceed, and the largest.
void set_order_figures(std::vector<double>& widths, Achieved& achieved) {
    if (widths.empty()) return;
    std::sort(widths.begin(), widths.end());
    achieved.largest = widths.back();
    achieved.percentile_99 = widths[(widths.size() - 1) * 99 / 100];
}

}  // namespace

Achieved summarise(const ScrambleSums& sums, const HalfWidth& half_width, bool light) {
    const double t = student_quantile(kTails, sums.scrambles() - 1);
    Achieved result;
    std::vector<double> widths;
    widths.reserve(sums.pixels());
    double squares = 0;
    double samples = 0;
    for (std::size_t i = 0; i < sums.pixels(); ++i) {
        const PixelEstimate pixel = estimate_pixel(sums, i);
        if (pixel.samples == 0) continue;
        double width = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double deviation = std::sqrt(pixel.variance[c]);
            const double shown = displayed_reach(pixel.mean[c], deviation, light);
            squares += shown * shown;
            width = std::max(width, displayed_reach(pixel.mean[c], t * deviation, light));
        }
        widths.push_back(half_width ? half_width(i) : width);
        result.fewest = widths.size() == 1 ? pixel.samples : std::min(result.fewest, pixel.samples);
        result.most = std::max(result.most, pixel.samples);
        samples += pixel.samples;
    }
    result.pixels = widths.size();
    if (widths.empty()) return result;
    const auto n = static_cast<double>(widths.size());
    result.rms = std::sqrt(squares / (3 * n));
    result.samples = samples / n;
    set_order_figures(widths, result);
    return result;
}

}  // namespace cobble::renderer
