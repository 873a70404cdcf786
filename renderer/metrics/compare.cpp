// SPDX-License-Identifier: MIT
#include "renderer/metrics/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ir/math/elementary.hpp"
#include "ir/math/srgb.hpp"
#include "renderer/metrics/flip.hpp"

namespace cobble::renderer {
namespace {

/// Keeps relMSE finite where the reference is black: Rousselle, Knaus and Zwicker, "Adaptive
/// Sampling and Reconstruction using Greedy Error Minimization", SIGGRAPH Asia 2011.
constexpr double kRelativeFloor = 0.01;

/// Filters beyond this are wider than any picture that is read.
constexpr double kMaxPixelsPerDegree = 4000;

std::string problem_of(const Plane32& plane) {
    if (plane.channels != 1 && plane.channels != 3) {
        return fmt::format("a picture has 1 or 3 channels, not {}", plane.channels);
    }
    if (plane.width == 0 || plane.height == 0 ||
        plane.values.size() != std::size_t{plane.width} * plane.height * plane.channels) {
        return "a picture without pixels cannot be compared";
    }
    return {};
}

std::string problem_of(const Plane32& a, const Plane32& b, const CompareOptions& options) {
    if (std::string problem = problem_of(a); !problem.empty()) return problem;
    if (std::string problem = problem_of(b); !problem.empty()) return problem;
    if (a.width != b.width || a.height != b.height) {
        return fmt::format("the pictures differ in size: {} x {} and {} x {}", a.width, a.height,
                           b.width, b.height);
    }
    if (!(options.pixels_per_degree > 0) || options.pixels_per_degree > kMaxPixelsPerDegree) {
        return fmt::format("pixels per degree must lie between 0 and {}, not {}",
                           kMaxPixelsPerDegree, options.pixels_per_degree);
    }
    return {};
}

math::Vec3d pixel_of(const Plane32& plane, std::size_t index) {
    const float* p = &plane.values[index * plane.channels];
    const std::size_t step = plane.channels == 3 ? 1 : 0;
    return {static_cast<double>(p[0]), static_cast<double>(p[step]),
            static_cast<double>(p[2 * step])};
}

/// Rows of both pictures that are worked on at once.
struct Band {
    std::size_t first, end;  ///< whose differences are wanted
    std::size_t from, to;    ///< which they depend on
};

/// Some 200 bytes a pixel are in use at once: bands keep that below half a gigabyte.
constexpr std::size_t kBandRows = 256;

std::vector<Band> bands_of(std::size_t height, std::size_t reach) {
    std::vector<Band> bands;
    for (std::size_t first = 0; first < height; first += kBandRows) {
        const std::size_t end = std::min(first + kBandRows, height);
        bands.push_back(
            {first, end, first - std::min(first, reach), std::min(end + reach, height)});
    }
    return bands;
}

/// The band's pixels, clamped to [0, 1] and decoded. Adds what was clamped in its own rows.
LinearImage linear_image(const Plane32& plane, const Band& band, bool light,
                         std::uint64_t& clamped) {
    LinearImage image{plane.width, band.to - band.from, {}};
    image.pixels.reserve(image.width * image.height);
    for (std::size_t y = band.from; y < band.to; ++y) {
        const bool own = y >= band.first && y < band.end;
        for (std::size_t x = 0; x < plane.width; ++x) {
            math::Vec3d pixel = pixel_of(plane, y * plane.width + x);
            if (!finite(pixel)) pixel = {};
            for (std::size_t c = 0; c < 3; ++c) {
                const double inside = std::clamp(pixel[c], 0.0, 1.0);
                if (own && inside != pixel[c] && c < plane.channels) ++clamped;
                pixel[c] = light ? inside : math::srgb_to_linear(inside);
            }
            image.pixels.push_back(pixel);
        }
    }
    return image;
}

void add_flip(const Plane32& a, const Plane32& b, const CompareOptions& options,
              Comparison& result) {
    result.map = {a.width, a.height, 1, {}};
    result.map.values.reserve(std::size_t{a.width} * a.height);
    for (const Band& band : bands_of(a.height, flip_reach(options.pixels_per_degree))) {
        const LinearImage image_a = linear_image(a, band, options.light_a, result.clamped);
        const LinearImage image_b = linear_image(b, band, options.light_b, result.clamped);
        const std::vector<double> all = flip(image_a, image_b, options.pixels_per_degree);
        const std::size_t skipped = (band.first - band.from) * a.width;
        for (std::size_t i = skipped; i < skipped + (band.end - band.first) * a.width; ++i) {
            result.flip += all[i];
            result.flip_maximum = std::max(result.flip_maximum, all[i]);
            result.map.values.push_back(static_cast<float>(all[i]));
        }
    }
    result.flip /= static_cast<double>(result.map.values.size());
}

void add_differences(const Plane32& a, const Plane32& b, Comparison& result) {
    const std::size_t pixels = std::size_t{a.width} * a.height;
    std::vector<double> largest;
    largest.reserve(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const math::Vec3d va = pixel_of(a, i);
        const math::Vec3d vb = pixel_of(b, i);
        if (!finite(va) || !finite(vb)) {
            ++result.not_finite;
            continue;
        }
        double most = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = vb[c] - va[c];
            result.mse += d * d;
            result.rel_mse += d * d / (va[c] * va[c] + kRelativeFloor);
            result.mae += std::fabs(d);
            most = std::max(most, std::fabs(d));
        }
        if (most > 0) ++result.differing;
        largest.push_back(most);
    }
    if (largest.empty()) return;
    const double count = 3 * static_cast<double>(largest.size());
    result.mse /= count;
    result.rel_mse /= count;
    result.mae /= count;
    std::sort(largest.begin(), largest.end());
    result.maximum = largest.back();
    // Nearest rank: the smallest value that at least 99 % of the pixels do not exceed.
    const std::size_t rank = (largest.size() * 99 + 99) / 100;
    result.percentile_99 = largest[rank - 1];
}

}  // namespace

Comparison compare(const Plane32& a, const Plane32& b, const CompareOptions& options) {
    Comparison result;
    result.error = problem_of(a, b, options);
    if (!result.error.empty()) return result;
    result.pixels_per_degree = options.pixels_per_degree;
    add_differences(a, b, result);
    add_flip(a, b, options, result);
    return result;
}

Plane32 heat_map(const Plane32& plane) {
    // Chosen for even steps of lightness between black and near white.
    constexpr std::array<math::Vec3d, 6> kStops{{{0.00, 0.00, 0.02},
                                                 {0.22, 0.06, 0.42},
                                                 {0.55, 0.14, 0.50},
                                                 {0.88, 0.32, 0.40},
                                                 {1.00, 0.64, 0.42},
                                                 {1.00, 0.98, 0.76}}};
    Plane32 result{plane.width, plane.height, 3, {}};
    result.values.reserve(plane.values.size() * 3);
    for (const float value : plane.values) {
        const auto v = static_cast<double>(value);
        const double position = (v > 0 ? (v < 1 ? v : 1) : 0) * (kStops.size() - 1);
        const std::size_t below = std::min(static_cast<std::size_t>(position), kStops.size() - 2);
        const double fraction = position - static_cast<double>(below);
        const math::Vec3d color = math::lerp(kStops[below], kStops[below + 1], fraction);
        for (std::size_t c = 0; c < 3; ++c) result.values.push_back(static_cast<float>(color[c]));
    }
    return result;
}

}  // namespace cobble::renderer
