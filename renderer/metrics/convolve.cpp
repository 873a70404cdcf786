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

/// out[x] += the sum over k of weights[k] taps[k][x]. Four taps at a time: reading and writing
/// `out` for each took longer than the arithmetic.
void add_weighted(const std::vector<const double*>& taps, const std::vector<double>& weights,
                  std::size_t count, double* out) {
    std::size_t k = 0;
    for (; k + 4 <= taps.size(); k += 4) {
        const double* const a = taps[k];
        const double* const b = taps[k + 1];
        const double* const c = taps[k + 2];
        const double* const d = taps[k + 3];
        const double wa = weights[k];
        const double wb = weights[k + 1];
        const double wc = weights[k + 2];
        const double wd = weights[k + 3];
        for (std::size_t x = 0; x < count; ++x) {
            out[x] += (wa * a[x] + wb * b[x]) + (wc * c[x] + wd * d[x]);
        }
    }
    for (; k < taps.size(); ++k) {
        for (std::size_t x = 0; x < count; ++x) out[x] += weights[k] * taps[k][x];
    }
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

Grid convolved_rows(const Grid& grid, const Kernel& kernel) {
    Grid result(grid.width, grid.height);
    const std::size_t radius = kernel.radius();
    std::vector<double> line(grid.width + 2 * radius);
    std::vector<const double*> taps(kernel.weights.size());
    for (std::size_t k = 0; k < taps.size(); ++k) taps[k] = &line[k];
    for (std::size_t y = 0; y < grid.height; ++y) {
        std::copy_n(&grid.values[y * grid.width], grid.width, &line[radius]);
        pad(line, grid.width, radius);
        add_weighted(taps, kernel.weights, grid.width, &result.values[y * grid.width]);
    }
    return result;
}

Grid convolved_columns(const Grid& grid, const Kernel& kernel) {
    Grid result(grid.width, grid.height);
    const std::size_t radius = kernel.radius();
    std::vector<const double*> taps(kernel.weights.size());
    for (std::size_t y = 0; y < grid.height; ++y) {
        for (std::size_t k = 0; k < taps.size(); ++k) {
            // Row y + k - radius, within the grid.
            const std::size_t shifted = y + k < radius ? 0 : y + k - radius;
            taps[k] = &grid.values[std::min(shifted, grid.height - 1) * grid.width];
        }
        add_weighted(taps, kernel.weights, grid.width, &result.values[y * grid.width]);
    }
    return result;
}

Grid convolved(const Grid& grid, const Kernel& horizontal, const Kernel& vertical) {
    return convolved_columns(convolved_rows(grid, horizontal), vertical);
}

}  // namespace cobble::renderer
