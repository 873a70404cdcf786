// SPDX-License-Identifier: MIT
#include "renderer/passes/adaptive_rounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/estimate/pixel_error.hpp"
#include "renderer/estimate/student.hpp"

namespace cobble::renderer {

std::uint32_t scramble_samples(std::uint32_t round, std::uint32_t most) {
    const std::uint64_t whole = (std::uint64_t{kFewestSamples} << round) / 2;
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(whole, std::max(most, kFewestSamples)) / kScrambles);
}

double standard_errors(std::uint32_t look) {
    static const auto kQuantiles = [] {
        std::array<double, kMostLooks + 1> quantiles{};
        for (std::uint32_t k = 1; k <= kMostLooks; ++k) {
            quantiles[k] = student_quantile(miss_probability(k), kScrambles - 1);
        }
        return quantiles;
    }();
    return kQuantiles[look];
}

Intervals::Intervals(const ScrambleSums& sums, const PixelMask& active, std::uint32_t width,
                     bool light)
    : sums_(&sums),
      active_(&active),
      width_(width),
      height_(width == 0 ? 0 : sums.pixels() / width),
      light_(light),
      of_one_(sums.pixels()) {}

void Intervals::estimate_row(std::uint32_t row) {
    const std::size_t first = row == 0 ? 0 : row - 1;
    const std::size_t last = std::min<std::size_t>(row + 2, height_);
    const auto asked_near = [&](std::size_t x) {
        for (std::size_t v = first; v < last; ++v) {
            for (std::size_t u = x == 0 ? 0 : x - 1; u < std::min(x + 2, width_); ++u) {
                if (active_->bytes()[v * width_ + u] != 0) return true;
            }
        }
        return false;
    };
    for (std::size_t x = 0; x < width_; ++x) {
        if (!asked_near(x)) continue;
        const std::size_t i = row * width_ + x;
        const PixelEstimate pixel = estimate_pixel(*sums_, i);
        of_one_[i] = pixel.variance * static_cast<double>(pixel.samples);
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
            widest,
            displayed_reach(own.mean[c], standard_errors(look) * std::sqrt(variance), light_));
    }
    return widest;
}

}  // namespace cobble::renderer
