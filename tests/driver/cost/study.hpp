// SPDX-License-Identifier: MIT
// Studies of cost that nobody made, with numbers as they are in life.
#pragma once

#include "renderer/cost/report.hpp"

namespace cobble::test {

/// Every part is there. Its pictures are so small that a page of them can be written down.
renderer::CostReport whole_study();

/// Stopped after two points of the curve; no effect, no choice.
renderer::CostReport cut_short_study();

/// Everything is there, and nothing of it is a number that a chart has a place for.
renderer::CostReport study_without_numbers();

}  // namespace cobble::test
