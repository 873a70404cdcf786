// SPDX-License-Identifier: MIT
#include "renderer/metrics/convolve.hpp"

#include <algorithm>

namespace cobble::renderer {
namespace {

/// `count` values, `radius` more of the first before and of the last behind.
void pad(std::vector<double>& line, std::size_t count, std::size_t radius) {
    std::fill_n(line.begin(), radius, line[radius]);
    std::fill_n(line.begin() + static_cast<std::ptrdiff_t>(radius + count), radius,
                line[radius + count - 1]);
}

}  // namespace

double Kernel::sum() const {
    double total = 0;
    for (const double weight : weights) total += weight;
    return total;
}

void Kernel::scale(double factor) {
    for (double& weight : weights) weight *= factor;
}

void Kernel::balance() {
    double positive = 0;
    double negative = 0;
    for (const double weight : weights) (weight > 0 ? positive : negative) += weight;
    const bool useless = !(positive > 0) || !(negative < 0);
    for (double& weight : weights) {
        weight = useless ? 0 : weight > 0 ? weight / positive : -weight / negative;
    }
}

Grid convolved(const Grid& grid, const Kernel& horizontal, const Kernel& vertical) {
    Grid between(grid.width, grid.height);
    std::size_t radius = horizontal.radius();
    std::vector<double> line(grid.width + 2 * radius);
    for (std::size_t y = 0; y < grid.height; ++y) {
        std::copy_n(&grid.values[y * grid.width], grid.width, &line[radius]);
        pad(line, grid.width, radius);
        double* out = &between.values[y * grid.width];
        for (std::size_t k = 0; k < horizontal.weights.size(); ++k) {
            const double weight = horizontal.weights[k];
            for (std::size_t x = 0; x < grid.width; ++x) out[x] += weight * line[x + k];
        }
    }
    Grid result(grid.width, grid.height);
    radius = vertical.radius();
    for (std::size_t y = 0; y < grid.height; ++y) {
        double* out = &result.values[y * grid.width];
        for (std::size_t k = 0; k < vertical.weights.size(); ++k) {
            // Row y + k - radius, within the grid.
            const std::size_t shifted = y + k < radius ? 0 : y + k - radius;
            const double* row = &between.values[std::min(shifted, grid.height - 1) * grid.width];
            const double weight = vertical.weights[k];
            for (std::size_t x = 0; x < grid.width; ++x) out[x] += weight * row[x];
        }
    }
    return result;
}

}  // namespace cobble::renderer
