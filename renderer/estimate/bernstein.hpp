// SPDX-License-Identifier: MIT
// The empirical Bernstein bound: how far the mean of independent numbers of [0, 1] may lie from
// their expectation, whatever their distribution. Maurer and Pontil, "Empirical Bernstein Bounds
// and Sample Variance Penalization", COLT 2009, theorem 4, for both sides.
#pragma once

#include <cstdint>

namespace cobble::renderer {

/// Exceeded with at most probability `miss`. `variance`: the unbiased one of `count` numbers, at
/// least 2. sqrt(2 v ln(4 / miss) / n) + 7 ln(4 / miss) / (3 (n - 1)).
double bernstein_half_width(double variance, std::uint32_t count, double miss);

/// The fewest numbers, a power of two from 2, that can give a half width of `error` at all: of a
/// variance of 0.
std::uint32_t bernstein_fewest(double error, double miss);

}  // namespace cobble::renderer
