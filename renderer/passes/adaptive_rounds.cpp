// SPDX-License-Identifier: MIT
#include "renderer/passes/adaptive_rounds.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/estimate/pixel_error.hpp"
#include "renderer/estimate/student.hpp"

namespace cobble::renderer {

std::uint32_t scramble_samples(std::uint32_t round, std::uint32_t most) {
    const std::uint64_t whole = (std::uint64_t{kFewestSamples} << round) / 2;
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(whole, std::max(most, kFewestSamples)) / kScrambles);
}

Intervals::Intervals(const ScrambleSums& sums, std::uint32_t width, bool light)
    : sums_(&sums),
      width_(width),
      height_(width == 0 ? 0 : sums.pixels() / width),
      light_(light),
      of_one_(sums.pixels()) {
    for (std::size_t i = 0; i < of_one_.size(); ++i) {
        const PixelEstimate pixel = estimate_pixel(sums, i);
        of_one_[i] = pixel.variance * static_cast<double>(pixel.samples);
    }
    for (std::uint32_t look = 1; look <= kMostLooks; ++look) {
        t_[look] = student_quantile(miss_probability(look), sums.scrambles() - 1);
    }
}

math::Vec3d Intervals::pooled(std::size_t pixel) const {
    const std::size_t x = pixel % width_;
    const std::size_t y = pixel / width_;
    math::Vec3d sum;
    double count = 0;
    for (std::size_t v = y == 0 ? 0 : y - 1; v < std::min(y + 2, height_); ++v) {
        for (std::size_t u = x == 0 ? 0 : x - 1; u < std::min(x + 2, width_); ++u) {
            sum += of_one_[v * width_ + u];
            count += 1;
        }
    }
    return sum / count;
}

double Intervals::half_width(std::size_t pixel, std::uint32_t look) const {
    const math::Vec3d around = pooled(pixel);
    const PixelEstimate own = estimate_pixel(*sums_, pixel);
    if (own.samples == 0) return 0;
    double widest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const double variance = std::max(of_one_[pixel][c], around[c]) / own.samples;
        widest = std::max(
            widest, displayed_half_width(own.mean[c], t_[look] * std::sqrt(variance), light_));
    }
    return widest;
}

double Intervals::mean_square() const {
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < of_one_.size(); ++i) {
        double samples = 0;
        for (std::uint32_t k = 0; k < sums_->scrambles(); ++k) samples += sums_->samples_of(i, k);
        if (samples == 0) continue;
        sum += (of_one_[i].x + of_one_[i].y + of_one_[i].z) / samples;
        count += 3;
    }
    return count == 0 ? 0 : sum / count;
}

}  // namespace cobble::renderer
