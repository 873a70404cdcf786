// SPDX-License-Identifier: MIT
// How large a pixel's error may be, from scrambles that are independent of each other.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ir/math/vec.hpp"
#include "renderer/film/scramble_sums.hpp"

namespace cobble::renderer {

/// A pixel's colour over several scrambles of equally many samples, or nearly so: where they do not
/// go in evenly, the mean is that of the scrambles, not of the samples.
struct PixelEstimate {
    math::Vec3d mean;
    /// Of the mean, channel by channel: the scrambles' variance over their number. Unbiased.
    math::Vec3d variance;
    std::uint32_t samples = 0;  ///< over all scrambles
};

/// Of pixel `pixel` of sums of at least two scrambles.
PixelEstimate estimate_pixel(const ScrambleSums& sums, std::size_t pixel);

/// How far the interval mean +- reach goes from the mean, on the side where it goes further, in
/// display values: clamped to those that a display has, and encoded if they are light.
double displayed_reach(double mean, double reach, bool light);

}  // namespace cobble::renderer
