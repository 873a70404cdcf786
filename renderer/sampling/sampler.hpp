// SPDX-License-Identifier: MIT
// Which random numbers a sample uses. A key names a set of points for good: neither tiles, threads,
// crops nor the effects that happen to be on move it.
#pragma once

#include <cstdint>

#include "renderer/sampling/hash.hpp"
#include "renderer/sampling/sample_pass.hpp"
#include "renderer/sampling/sobol.hpp"

namespace cobble::renderer {

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

/// Point `index` of a set whose points have nothing to do with each other.
constexpr Uniform2 random_point(std::uint32_t index, std::uint64_t set) {
    const std::uint64_t bits = combine(set, index);
    return {static_cast<std::uint32_t>(bits) * kTwoToMinus32,
            static_cast<std::uint32_t>(bits >> 32U) * kTwoToMinus32};
}

/// One sample of one pixel.
class Sampler {
  public:
    /// (x, y) in the whole picture.
    Sampler(std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample)
        : pixel_(combine(combine(seed, x), y)), sample_(sample) {}
    Sampler(const SamplePass& pass, std::uint32_t x, std::uint32_t y, std::uint32_t sample)
        : pixel_(combine(combine(pass.seed, x), y)),
          salts_(pass.salts),
          sample_(sample),
          scatter_(pass.scatter) {}

    [[nodiscard]] Uniform2 draw(Draw what) const { return draw(what, PathAddress{}, 0); }

    /// `light`: its index in the scene.
    [[nodiscard]] Uniform2 draw(Draw what, PathAddress path, std::uint32_t light) const {
        return point(sample_, set(what, path, light));
    }
    /// One of `count` for each sample: number `number` of them, below `count`.
    [[nodiscard]] Uniform2 draw(Draw what, PathAddress path, std::uint32_t light,
                                std::uint32_t number, std::uint32_t count) const {
        return point(sample_ * count + number, set(what, path, light));
    }

    /// The name of the set that draw() takes a point of, the same for all samples of the pixel.
    [[nodiscard]] std::uint64_t set(Draw what, PathAddress path, std::uint32_t light) const {
        const std::uint64_t kind = static_cast<std::uint64_t>(what);
        const std::uint64_t salt = salts_ >> (16U * (kind - 1U)) & 0xffffU;
        const std::uint64_t effect = salt << 40U | kind << 32U | light;
        return combine(combine(pixel_, effect), path.value());
    }

  private:
    [[nodiscard]] Uniform2 point(std::uint32_t index, std::uint64_t of) const {
        return scatter_ == Scatter::kSobol ? sobol_point(index, of) : random_point(index, of);
    }

    std::uint64_t pixel_;
    std::uint64_t salts_ = 0;
    std::uint32_t sample_;
    Scatter scatter_ = Scatter::kSobol;
};

}  // namespace cobble::renderer
