// SPDX-License-Identifier: MIT
// How uncertain a figure is that was made of a few independent parts.
#pragma once

#include <vector>

namespace cobble::renderer {

/// Half the width of a 95 % interval around a figure, from the same figure without each of the n
/// parts in turn, at least 2: Student's t times sqrt((n - 1) / n times the sum of their squared
/// distances from their mean) (Tukey's jackknife; Miller, Biometrika 61(1), 1974).
double jackknife_reach(const std::vector<double>& left_out);

}  // namespace cobble::renderer
