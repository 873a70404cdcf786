// SPDX-License-Identifier: MIT
// LDR-FLIP: what an eye that flips between two pictures on a monitor sees of their difference.
// After Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem and Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020. Section
// numbers in this folder are that paper's.
#pragma once

#include <vector>

#include "ir/math/vec.hpp"

namespace cobble::renderer {

/// Rows from the top; linear RGB in [0, 1] with the primaries of sRGB.
struct LinearImage {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<math::Vec3d> pixels;
};

/// How many pixels away a pixel still matters: the reach of the widest filter.
std::size_t flip_reach(double pixels_per_degree);

/// The difference at each pixel, in [0, 1]. Images of one size, at least one pixel.
std::vector<double> flip(const LinearImage& reference, const LinearImage& test,
                         double pixels_per_degree);

}  // namespace cobble::renderer
