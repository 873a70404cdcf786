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

double displayed_half_width(double mean, double reach, bool light) {
    double low = std::clamp(mean - reach, 0.0, 1.0);
    double high = std::clamp(mean + reach, 0.0, 1.0);
    if (light) {
        low = math::linear_to_srgb(low);
        high = math::linear_to_srgb(high);
    }
    return (high - low) / 2;
}

}  // namespace cobble::renderer
