// SPDX-License-Identifier: MIT
// From the high-resolution samples of a stretch of picture to its pixels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ir/scene/scene.hpp"
#include "renderer/compat/rules.hpp"

namespace cobble::renderer {

/// The course's weights; they sum to 1.0011, and so its filtered pictures are that much brighter.
inline constexpr std::array<double, 5> kCompatKernel{0.1201, 0.2339, 0.2931, 0.2339, 0.1201};

/// The samples under pixels [x0, x1) x [y0, y1), and those beyond that the kernel reaches. What
/// lies outside the picture is not stored: the picture's edge is repeated.
class SampleGrid {
  public:
    SampleGrid(const CompatRules& rules, std::uint32_t width, std::uint32_t height,
               std::uint32_t x0, std::uint32_t y0, std::uint32_t x1, std::uint32_t y1);

    /// How many samples there are to fill, and the place of each in the high-resolution picture
    /// (rows from the top): sample k of set() and count() is the k-th row by row.
    [[nodiscard]] std::uint64_t count() const { return samples_.size(); }
    [[nodiscard]] std::uint32_t x(std::uint64_t k) const {
        return left_ + static_cast<std::uint32_t>(k % columns_);
    }
    [[nodiscard]] std::uint32_t y(std::uint64_t k) const {
        return top_ + static_cast<std::uint32_t>(k / columns_);
    }
    void set(std::uint64_t k, ir::Color color) { samples_[k] = color; }

    /// The number of samples that must be filled before the pixels of row y can be had.
    [[nodiscard]] std::uint64_t needed_for_row(std::uint32_t y) const;
    /// The pixel's colour: the kernel across, then upwards at each sample, then the mean. Summed in
    /// one order, so that it does not depend on the stretch that it was computed in.
    [[nodiscard]] ir::Color pixel(std::uint32_t x, std::uint32_t y) const;

  private:
    [[nodiscard]] ir::Color at(std::int64_t x, std::int64_t y) const;
    [[nodiscard]] ir::Color blurred(std::int64_t x, std::int64_t y) const;

    std::uint32_t grid_;
    bool kernel_;
    std::uint32_t left_, top_;  ///< of the samples that are stored, in the high-resolution picture
    std::uint32_t columns_;
    std::int64_t last_x_, last_y_;  ///< of the whole picture
    std::uint32_t rows_;
    std::vector<ir::Color> samples_;
};

}  // namespace cobble::renderer
