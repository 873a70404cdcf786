// SPDX-License-Identifier: MIT
#include "renderer/metrics/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>

#include "ir/math/elementary.hpp"
#include "ir/math/srgb.hpp"
#include "renderer/job/scheduler.hpp"
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

/// A part of both pictures that is worked on at once.
struct Tile {
    struct Range {
        std::size_t first, end;  ///< whose differences are wanted
        std::size_t from, to;    ///< which they depend on
    };
    Range x, y;

    [[nodiscard]] bool owns(std::size_t px, std::size_t py) const {
        return px >= x.first && px < x.end && py >= y.first && py < y.end;
    }
};

/// Some 200 bytes a pixel are in use at once: of this size they stay near the processor. Tiles of
/// wide filters are larger, lest most of the work be done for their margins.
constexpr std::size_t kTileSide = 256;

std::vector<Tile::Range> ranges_of(std::size_t size, std::size_t reach) {
    const std::size_t side = std::max(kTileSide, 2 * reach);
    std::vector<Tile::Range> ranges;
    for (std::size_t first = 0; first < size; first += side) {
        const std::size_t end = std::min(first + side, size);
        ranges.push_back({first, end, first - std::min(first, reach), std::min(end + reach, size)});
    }
    return ranges;
}

/// Display values as light, each value's result kept: pictures hold few different ones.
class ToLight {
  public:
    double operator()(double value) {
        const auto single = static_cast<float>(value);
        Known& known = known_[(std::bit_cast<std::uint32_t>(single) * 2654435761U) >> 22U];
        if (known.value != single) known = {single, math::srgb_to_linear(value)};
        return known.light;
    }

  private:
    struct Known {
        float value = -1;
        double light = 0;
    };
    std::array<Known, 1024> known_{};
};

/// The tile's pixels, clamped to [0, 1] and decoded. Adds what was clamped in its own ones.
LinearImage linear_image(const Plane32& plane, const Tile& tile, bool light,
                         std::uint64_t& clamped) {
    LinearImage image{tile.x.to - tile.x.from, tile.y.to - tile.y.from, {}};
    image.pixels.reserve(image.width * image.height);
    ToLight to_light;
    for (std::size_t y = tile.y.from; y < tile.y.to; ++y) {
        for (std::size_t x = tile.x.from; x < tile.x.to; ++x) {
            math::Vec3d pixel = pixel_of(plane, y * plane.width + x);
            if (!finite(pixel)) pixel = {};
            for (std::size_t c = 0; c < 3; ++c) {
                const double inside = std::clamp(pixel[c], 0.0, 1.0);
                if (inside != pixel[c] && c < plane.channels && tile.owns(x, y)) ++clamped;
                pixel[c] = light ? inside : to_light(inside);
            }
            image.pixels.push_back(pixel);
        }
    }
    return image;
}

/// All that the tile's differences depend on is the same, bit by bit.
bool equal_in(const Plane32& a, const Plane32& b, const Tile& tile, const CompareOptions& options) {
    if (options.light_a != options.light_b || a.channels != b.channels) return false;
    for (std::size_t y = tile.y.from; y < tile.y.to; ++y) {
        const std::size_t first = (y * a.width + tile.x.from) * a.channels;
        const std::size_t bytes = (tile.x.to - tile.x.from) * a.channels * sizeof(float);
        if (std::memcmp(&a.values[first], &b.values[first], bytes) != 0) return false;
    }
    return true;
}

struct TileSum {
    double flip = 0;
    double maximum = 0;
    std::uint64_t clamped = 0;
};

/// Of a picture that is compared with itself.
std::uint64_t clamped_in(const Plane32& plane, const Tile& tile) {
    std::uint64_t clamped = 0;
    for (std::size_t y = tile.y.first; y < tile.y.end; ++y) {
        for (std::size_t x = tile.x.first; x < tile.x.end; ++x) {
            const std::size_t pixel = y * plane.width + x;
            if (!finite(pixel_of(plane, pixel))) continue;
            for (std::size_t c = 0; c < plane.channels; ++c) {
                const float value = plane.values[pixel * plane.channels + c];
                if (value < 0 || value > 1) ++clamped;
            }
        }
    }
    return clamped;
}

TileSum flip_in(const Plane32& a, const Plane32& b, const Tile& tile, const CompareOptions& options,
                Plane32& map) {
    TileSum sum;
    if (equal_in(a, b, tile, options)) {
        // The map holds zeros already.
        sum.clamped = 2 * clamped_in(a, tile);
        return sum;
    }
    const LinearImage image_a = linear_image(a, tile, options.light_a, sum.clamped);
    const LinearImage image_b = linear_image(b, tile, options.light_b, sum.clamped);
    const std::vector<double> all = flip(image_a, image_b, options.pixels_per_degree);
    for (std::size_t y = tile.y.first; y < tile.y.end; ++y) {
        for (std::size_t x = tile.x.first; x < tile.x.end; ++x) {
            const double value = all[(y - tile.y.from) * image_a.width + (x - tile.x.from)];
            sum.flip += value;
            sum.maximum = std::max(sum.maximum, value);
            map.values[y * map.width + x] = static_cast<float>(value);
        }
    }
    return sum;
}

void add_flip(const Plane32& a, const Plane32& b, const CompareOptions& options,
              Comparison& result) {
    const std::size_t pixels = std::size_t{a.width} * a.height;
    result.map = {a.width, a.height, 1, std::vector<float>(pixels)};
    const std::size_t reach = flip_reach(options.pixels_per_degree);
    std::vector<Tile> tiles;
    for (const Tile::Range& y : ranges_of(a.height, reach)) {
        for (const Tile::Range& x : ranges_of(a.width, reach)) tiles.push_back({x, y});
    }
    std::vector<TileSum> sums(tiles.size());
    std::atomic<std::size_t> next{0};
    const auto scheduler = make_thread_scheduler(options.threads);
    scheduler->run([&](std::uint32_t) {
        for (std::size_t i = next++; i < tiles.size(); i = next++) {
            sums[i] = flip_in(a, b, tiles[i], options, result.map);
        }
    });
    // In one order, whoever was first.
    for (const TileSum& sum : sums) {
        result.flip += sum.flip;
        result.flip_maximum = std::max(result.flip_maximum, sum.maximum);
        result.clamped += sum.clamped;
    }
    result.flip /= static_cast<double>(pixels);
}

void add_differences(const Plane32& a, const Plane32& b, double tolerance, Comparison& result) {
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
        if (most > tolerance) ++result.beyond_tolerance;
        largest.push_back(most);
    }
    if (largest.empty()) return;
    const double count = 3 * static_cast<double>(largest.size());
    result.mse /= count;
    result.rel_mse /= count;
    result.mae /= count;
    result.maximum = *std::max_element(largest.begin(), largest.end());
    // Nearest rank: the smallest value that at least 99 % of the pixels do not exceed. It is one
    // number, whatever the order of those beside it.
    const std::size_t rank = (largest.size() * 99 + 99) / 100;
    const auto at = largest.begin() + static_cast<std::ptrdiff_t>(rank - 1);
    std::nth_element(largest.begin(), at, largest.end());
    result.percentile_99 = *at;
}

}  // namespace

Comparison compare(const Plane32& a, const Plane32& b, const CompareOptions& options) {
    Comparison result;
    result.error = problem_of(a, b, options);
    if (!result.error.empty()) return result;
    result.pixels_per_degree = options.pixels_per_degree;
    add_differences(a, b, options.tolerance, result);
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
