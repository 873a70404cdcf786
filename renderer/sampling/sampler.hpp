// SPDX-License-Identifier: MIT
// Which random numbers a sample uses. A key names a set of points for good: neither tiles, threads,
// crops nor the effects that happen to be on move it.
#pragma once

#include <cstdint>

#include "renderer/sampling/hash.hpp"
#include "renderer/sampling/sobol.hpp"

namespace cobble::renderer {

/// What draws numbers. Values are part of every picture's meaning: never renumber.
enum class Draw : std::uint8_t { kPixel = 1, kLens = 2, kTime = 3, kLight = 4 };

/// Where a ray stands in its camera ray's tree: a leading 1, then 0 for each reflection and 1 for
/// each refraction on the way. Beyond 62 turns the string is hashed, so that no depth is too deep.
class PathAddress {
  public:
    [[nodiscard]] constexpr PathAddress reflected() const { return child(0); }
    [[nodiscard]] constexpr PathAddress refracted() const { return child(1); }
    [[nodiscard]] constexpr std::uint64_t value() const { return value_; }

  private:
    [[nodiscard]] constexpr PathAddress child(std::uint64_t turn) const {
        PathAddress result;
        const bool full = (value_ >> 63U) != 0;
        // A hashed string keeps the top bit, so that it equals no short one.
        result.value_ =
            full ? combine(value_, turn) | (std::uint64_t{1} << 63U) : value_ << 1U | turn;
        return result;
    }

    std::uint64_t value_ = 1;
};

/// One sample of one pixel.
class Sampler {
  public:
    /// (x, y) in the whole picture.
    Sampler(std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample)
        : pixel_(combine(combine(seed, x), y)), sample_(sample) {}

    [[nodiscard]] Uniform2 draw(Draw what) const { return draw(what, PathAddress{}, 0); }

    /// `light`: its index in the scene.
    [[nodiscard]] Uniform2 draw(Draw what, PathAddress path, std::uint32_t light) const {
        return sobol_point(sample_, set(what, path, light));
    }

    /// The name of the set that draw() takes a point of, the same for all samples of the pixel.
    [[nodiscard]] std::uint64_t set(Draw what, PathAddress path, std::uint32_t light) const {
        const std::uint64_t effect = static_cast<std::uint64_t>(what) << 32U | light;
        return combine(combine(pixel_, effect), path.value());
    }

  private:
    std::uint64_t pixel_;
    std::uint32_t sample_;
};

}  // namespace cobble::renderer
