// SPDX-License-Identifier: MIT
// How a picture's error falls with its samples, without a reference picture: from the scatter of
// scrambles that are independent of each other.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/cost/report.hpp"
#include "renderer/film/scramble_sums.hpp"

namespace cobble::renderer {

/// The scatter of the scrambles' pictures at one number of samples.
struct Scatters {
    std::uint32_t samples = 0;     ///< a pixel of one scramble
    double seconds = 0;            ///< of one picture, with its preparation
    double mean_square = 0;        ///< error of one scramble's picture, over pixels and channels
    std::vector<double> left_out;  ///< the same without each of the scrambles
};

/// Unbiased. Of sums of at least three scrambles, encoded to be shown if they are `light`. Cost:
/// some 0.2 us a pixel and scramble.
Scatters scatter_of(const ScrambleSums& sums, std::uint32_t samples, double seconds,
                    bool light = false);

/// Errors with bands, and the slope of a straight line through the upper half of the points (of
/// four to six through all but the first), in logarithms; bands by the jackknife over scrambles
/// (Efron and Stein, Annals of Statistics 9(3), 1981) with Student's t. Points without any error
/// are not in the line. All of `points` have the same number of scrambles.
ErrorCurve make_curve(const std::vector<Scatters>& points);

}  // namespace cobble::renderer
