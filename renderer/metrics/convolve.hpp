// SPDX-License-Identifier: MIT
// Separable filters on grids of doubles.
#pragma once

#include <cstddef>
#include <vector>

namespace cobble::renderer {

struct Grid {
    Grid() = default;
    Grid(std::size_t w, std::size_t h) : width(w), height(h), values(w * h) {}
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<double> values;
};

/// Weights at the offsets -radius to radius.
struct Kernel {
    std::vector<double> weights;

    [[nodiscard]] std::size_t radius() const { return weights.size() / 2; }
    [[nodiscard]] double sum() const;
    void scale(double factor);
    /// Scales the positive weights to the sum 1 and the negative ones to -1. A kernel without
    /// either becomes zero: it sees nothing.
    void balance();
};

/// `function` at each offset.
template <typename Function>
Kernel sampled_kernel(std::size_t radius, const Function& function) {
    Kernel kernel;
    kernel.weights.reserve(2 * radius + 1);
    for (std::size_t i = 0; i <= 2 * radius; ++i) {
        kernel.weights.push_back(function(static_cast<double>(i) - static_cast<double>(radius)));
    }
    return kernel;
}

/// Correlates each row, or each column, with the kernel; outside the grid its edge is repeated.
/// Cost: width height length multiplications, in one order.
Grid convolved_rows(const Grid& grid, const Kernel& kernel);
Grid convolved_columns(const Grid& grid, const Kernel& kernel);

/// Rows, then columns.
Grid convolved(const Grid& grid, const Kernel& horizontal, const Kernel& vertical);

}  // namespace cobble::renderer
