// SPDX-License-Identifier: MIT
// What a render says of its error, for people: what is to be expected, and what was reached.
#pragma once

#include <string>

#include "renderer/cost/budget.hpp"
#include "renderer/estimate/achieved.hpp"
#include "renderer/settings.hpp"

namespace cobble::driver {

// One line each, with its end.

/// Before a guaranteed picture begins.
std::string guarantee_text(const renderer::ErrorGoal& goal);
/// Once the first samples of a picture with an error to reach are there.
std::string forecast_text(const renderer::Forecast& forecast, double error);
/// Before the picture that a trial chose.
std::string budget_text(const renderer::BudgetChoice& choice, std::uint32_t scrambles,
                        double budget);
/// Afterwards; `goal` may be null.
std::string achieved_text(const renderer::Achieved& achieved, const renderer::ErrorGoal* goal);

}  // namespace cobble::driver
