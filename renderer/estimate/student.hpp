// SPDX-License-Identifier: MIT
// Student's t: how far the mean of a few numbers may lie from the truth.
#pragma once

#include <cstdint>

namespace cobble::renderer {

/// The probability that |t| <= `t`, of `degrees` degrees of freedom, at least 1; `t` >= 0. Closed
/// forms of Abramowitz and Stegun, Handbook of Mathematical Functions, 26.7.3 and 26.7.4.
/// The same bits everywhere; cost grows with `degrees`.
double student_probability(double t, std::uint32_t degrees);

/// The t that |t| exceeds with probability `tails`, in (0, 1): half the width of a confidence
/// interval in standard errors. To 12 digits. Some 60 student_probability()s: not for inner loops.
double student_quantile(double tails, std::uint32_t degrees);

}  // namespace cobble::renderer
