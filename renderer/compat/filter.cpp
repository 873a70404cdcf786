// SPDX-License-Identifier: MIT
#include "renderer/compat/filter.hpp"

#include <algorithm>

namespace cobble::renderer {
namespace {

constexpr std::uint32_t kReach = kCompatKernel.size() / 2;

}  // namespace

SampleGrid::SampleGrid(const CompatRules& rules, std::uint32_t width, std::uint32_t height,
                       std::uint32_t x0, std::uint32_t y0, std::uint32_t x1, std::uint32_t y1)
    : grid_(rules.grid), kernel_(rules.kernel) {
    const std::uint32_t reach = kernel_ ? kReach : 0;
    const auto before = [&](std::uint32_t first) {
        return first * grid_ < reach ? 0 : first * grid_ - reach;
    };
    left_ = before(x0);
    top_ = before(y0);
    columns_ = std::min(x1 * grid_ + reach, width * grid_) - left_;
    rows_ = std::min(y1 * grid_ + reach, height * grid_) - top_;
    last_x_ = std::int64_t{width} * grid_ - 1;
    last_y_ = std::int64_t{height} * grid_ - 1;
    samples_.resize(std::size_t{columns_} * rows_);
}

std::uint64_t SampleGrid::needed_for_row(std::uint32_t y) const {
    const std::uint64_t below = (std::uint64_t{y} + 1) * grid_ + (kernel_ ? kReach : 0);
    return std::min<std::uint64_t>(below - top_, rows_) * columns_;
}

ir::Color SampleGrid::at(std::int64_t x, std::int64_t y) const {
    const auto column = std::clamp<std::int64_t>(x, 0, last_x_) - left_;
    const auto row = std::clamp<std::int64_t>(y, 0, last_y_) - top_;
    return samples_[static_cast<std::size_t>(row * columns_ + column)];
}

ir::Color SampleGrid::blurred(std::int64_t x, std::int64_t y) const {
    ir::Color sum;
    for (std::size_t j = 0; j < kCompatKernel.size(); ++j) {
        ir::Color line;
        const std::int64_t row = y + static_cast<std::int64_t>(j) - std::int64_t{kReach};
        for (std::size_t i = 0; i < kCompatKernel.size(); ++i) {
            const std::int64_t column = x + static_cast<std::int64_t>(i) - std::int64_t{kReach};
            line += kCompatKernel[i] * at(column, row);
        }
        sum += kCompatKernel[j] * line;
    }
    return sum;
}

ir::Color SampleGrid::pixel(std::uint32_t x, std::uint32_t y) const {
    if (grid_ == 1 && !kernel_) return at(x, y);
    ir::Color sum;
    for (std::uint32_t j = 0; j < grid_; ++j) {
        for (std::uint32_t i = 0; i < grid_; ++i) {
            const std::int64_t column = std::int64_t{x} * grid_ + i;
            const std::int64_t row = std::int64_t{y} * grid_ + j;
            sum += kernel_ ? blurred(column, row) : at(column, row);
        }
    }
    return sum / static_cast<double>(grid_ * grid_);
}

}  // namespace cobble::renderer
