// SPDX-License-Identifier: MIT
#include "renderer/estimate/pixel_error.hpp"

#include <algorithm>

#include "ir/math/srgb.hpp"

namespace cobble::renderer {

PixelEstimate estimate_pixel(const ScrambleSums& sums, std::size_t pixel) {
    const std::uint32_t scrambles = sums.scrambles();
    PixelEstimate result;
    for (std::uint32_t k = 0; k < scrambles; ++k) {
        result.mean += sums.mean_of(pixel, k);
        result.samples += sums.samples_of(pixel, k);
    }
    const double n = scrambles;
    result.mean = result.mean / n;
    for (std::uint32_t k = 0; k < scrambles; ++k) {
        const math::Vec3d off = sums.mean_of(pixel, k) - result.mean;
        result.variance += off * off;
    }
    result.variance = result.variance / (n * (n - 1));
    return result;
}

double displayed_reach(double mean, double reach, bool light) {
    const auto shown = [light](double value) {
        const double clamped = std::clamp(value, 0.0, 1.0);
        return light ? math::linear_to_srgb(clamped) : clamped;
    };
    const double middle = shown(mean);
    return std::max(shown(mean + reach) - middle, middle - shown(mean - reach));
}

}  // namespace cobble::renderer
