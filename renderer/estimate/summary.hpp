// SPDX-License-Identifier: MIT
// How exact a picture of several scrambles is, in figures.
#pragma once

#include <functional>

#include "renderer/estimate/achieved.hpp"
#include "renderer/film/scramble_sums.hpp"

namespace cobble::renderer {

/// Half the width of a pixel's 95 % interval, in display values, of its largest channel.
using HalfWidth = std::function<double(std::size_t pixel)>;

/// Of sums of at least two scrambles; pixels without samples are left out. Without `half_width` it
/// is Student's interval of each pixel by itself. `light`: values are encoded to be shown.
Achieved summarise(const ScrambleSums& sums, const HalfWidth& half_width, bool light);

}  // namespace cobble::renderer
