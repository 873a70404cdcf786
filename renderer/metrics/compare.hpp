// SPDX-License-Identifier: MIT
// How far two pictures are from each other, as numbers and as a map.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "renderer/film/picture.hpp"

namespace cobble::renderer {

/// 0.7 m from a 3840 pixel wide monitor of 0.7 m: the setting of the FLIP paper.
inline constexpr double kDefaultPixelsPerDegree = 67;

struct CompareOptions {
    double pixels_per_degree = kDefaultPixelsPerDegree;  ///< > 0, for FLIP only
    bool light_a = false;  ///< `a` holds light (linear), not display values; for FLIP only
    bool light_b = false;
    std::uint32_t threads = 1;  ///< workers; 0: one a processor
    /// From 0; how far values may be apart, which beyond_tolerance counts by.
    double tolerance = std::numeric_limits<double>::infinity();
};

/// All figures but FLIP are of the numbers as they are, not clamped. A pixel in which either
/// picture has a NaN or an infinity is left out of them and counted, and is black for FLIP.
struct Comparison {
    double mse = 0;            ///< mean of (a - b)^2 over pixels and channels
    double rel_mse = 0;        ///< mean of (a - b)^2 / (a^2 + 0.01): relative to the first picture
    double mae = 0;            ///< mean of |a - b|
    double maximum = 0;        ///< largest |a - b|
    double percentile_99 = 0;  ///< of each pixel's largest |a - b|: 99 % of pixels are not above
    double flip = 0;           ///< mean of FLIP over all pixels, in [0, 1]
    double flip_maximum = 0;
    double pixels_per_degree = 0;  ///< that FLIP assumed
    std::uint64_t clamped = 0;     ///< values of both pictures outside [0, 1], clamped for FLIP
    std::uint64_t not_finite = 0;  ///< pixels with a NaN or infinity in either picture
    std::uint64_t differing = 0;   ///< pixels with any difference
    std::uint64_t beyond_tolerance = 0;  ///< pixels with a difference above the tolerance
    Plane32 map;                         ///< FLIP of each pixel, in [0, 1], one channel
    std::string error;                   ///< empty if the pictures can be compared
};

/// `a` is the one that `b` is measured against (it matters for rel_mse alone). Pictures of one or
/// three channels (one: grey) and of one size; errors otherwise. Cost: about 0.7 microseconds a
/// pixel at 67 pixels per degree where they differ, next to nothing where they do not; the filters
/// grow with that number, which is at most 4000 for a picture's worth of memory and time. The
/// result has the same bits everywhere.
Comparison compare(const Plane32& a, const Plane32& b, const CompareOptions& options = {});

/// Each number in [0, 1] of a one-channel plane as a colour, from black over purple and orange to a
/// pale yellow; lightness rises steadily, so that the map reads in grey too.
Plane32 heat_map(const Plane32& plane);

}  // namespace cobble::renderer
