// SPDX-License-Identifier: MIT
#include "tools/bench/frames/compare.hpp"

#include <cmath>
#include <fstream>
#include <iterator>

#include "renderer/picture/picture_io.hpp"

namespace cobble::bench {

namespace {

renderer::Plane32 read_reduced(const std::string& path, std::uint32_t n) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const renderer::Plane32 from = renderer::decode(bytes).plane;
    renderer::Plane32 to;
    to.width = from.width / n;
    to.height = from.height / n;
    const float part = 1.0F / static_cast<float>(n * n);
    for (std::uint32_t y = 0; y < to.height; ++y) {
        for (std::uint32_t x = 0; x < to.width; ++x) {
            for (std::uint32_t c = 0; c < 3; ++c) {
                float sum = 0;
                for (std::uint32_t i = 0; i < n * n; ++i) {
                    sum += from.at(x * n + i % n, y * n + i / n, c);
                }
                to.values.push_back(sum * part);
            }
        }
    }
    return to;
}

}  // namespace

std::optional<double> picture_difference(const std::string& path, unsigned enlargement,
                                         const std::string& other_path,
                                         unsigned other_enlargement) {
    const renderer::Plane32 a = read_reduced(path, enlargement);
    const renderer::Plane32 b = read_reduced(other_path, other_enlargement);
    if (a.width != b.width || a.height != b.height || a.values.empty()) return {};
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        sum += std::fabs(static_cast<double>(a.values[i] - b.values[i]));
    }
    return sum / static_cast<double>(a.values.size());
}

}  // namespace cobble::bench
