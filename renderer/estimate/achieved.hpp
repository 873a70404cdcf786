// SPDX-License-Identifier: MIT
// What a render says of its own error and of what it took, beforehand and afterwards.
#pragma once

#include <cstdint>
#include <optional>

namespace cobble::renderer {

/// Of a picture's remaining work, told once its first samples were there.
struct Forecast {
    double seconds = 0;  ///< of rendering, in all, those first samples among them
    double samples = 0;  ///< a pixel, on average
};

/// Errors in display values, of the largest channel.
struct Achieved {
    /// Square root of the mean over pixels and channels of the estimated squared error.
    double rms = 0;
    /// Half the widths of the pixels' intervals: the largest, and the one that 99 % do not exceed.
    double largest = 0, percentile_99 = 0;
    std::uint64_t pixels = 0;
    std::uint64_t beyond_goal = 0;  ///< pixels that took all samples allowed and are not there
    double samples = 0;             ///< a pixel, on average
    std::uint32_t fewest = 0, most = 0;
    std::optional<Forecast> forecast;
};

}  // namespace cobble::renderer
