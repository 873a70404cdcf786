// SPDX-License-Identifier: MIT
// The arithmetic of adaptive sampling: how many samples each round brings a pixel to, and which
// pixels their samples say are done.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/film/scramble_sums.hpp"
#include "renderer/passes/looks.hpp"
#include "renderer/settings.hpp"
#include "renderer/tile/pixel_mask.hpp"

namespace cobble::renderer {

/// Enough for Student's t to be of use (7 degrees of freedom: 2.4 standard errors, where very many
/// would be 2), and few enough that each has an eighth of the samples to be even in.
inline constexpr std::uint32_t kScrambles = 8;
/// Below this many a pixel's own scatter tells nothing of an edge that few samples met.
inline constexpr std::uint32_t kFewestSamples = 64;

/// Round 0 brings pixels to half of kFewestSamples, to learn how errors fall; round 1 to all of
/// them; each after it to twice as many, `most` at most. Samples of one scramble.
std::uint32_t scramble_samples(std::uint32_t round, std::uint32_t most);

/// Half the widths of pixels' intervals at a look, in display values, of the largest channel. The
/// standard error is the larger of the pixel's own and of that pooled over its neighbours, three by
/// three, each as if it had taken as many samples: few scrambles that happen to agree do not end a
/// pixel by themselves.
class Intervals {
  public:
    /// `width` pixels a row.
    Intervals(const ScrambleSums& sums, std::uint32_t width, bool light);

    /// At look `look`, from 1.
    [[nodiscard]] double half_width(std::size_t pixel, std::uint32_t look) const;
    /// Half the width of a look's interval, in standard errors.
    [[nodiscard]] double standard_errors(std::uint32_t look) const { return t_[look]; }
    /// Mean over pixels and channels of the estimated squared error.
    [[nodiscard]] double mean_square() const;

  private:
    [[nodiscard]] math::Vec3d pooled(std::size_t pixel) const;

    const ScrambleSums* sums_;
    std::size_t width_, height_;
    bool light_;
    /// By pixel: variance of the mean, times samples.
    std::vector<math::Vec3d> of_one_;
    std::array<double, kMostLooks + 1> t_{};
};

}  // namespace cobble::renderer
