// SPDX-License-Identifier: MIT
// The arithmetic of adaptive sampling: how many samples each round brings a pixel to, and which
// pixels their samples say are done.
#pragma once

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
    /// `active`: the pixels that are asked about, of the window that `sums` is of, `width` pixels a
    /// row.
    Intervals(const ScrambleSums& sums, const PixelMask& active, std::uint32_t width, bool light);

    [[nodiscard]] std::uint32_t rows() const { return static_cast<std::uint32_t>(height_); }
    /// What half_width() needs of a row and of its neighbours above and below. Different rows from
    /// different threads at once. Some 0.2 us for each pixel that is asked about or beside one.
    void estimate_row(std::uint32_t row);
    /// At look `look`, from 1; of a pixel that is asked about. Some 0.1 us.
    [[nodiscard]] double half_width(std::size_t pixel, std::uint32_t look) const;

  private:
    [[nodiscard]] math::Vec3d pooled(std::size_t pixel) const;

    const ScrambleSums* sums_;
    const PixelMask* active_;
    std::size_t width_, height_;
    bool light_;
    /// By pixel: variance of the mean, times samples.
    std::vector<math::Vec3d> of_one_;
};

/// Half the width of a look's interval, in standard errors.
double standard_errors(std::uint32_t look);

}  // namespace cobble::renderer
