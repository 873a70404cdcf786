// SPDX-License-Identifier: MIT
// What accuracy costs in time: a finished study for people, for programs, as a chart and as a page.
//
// All of them are pure functions of the study: one study gives the same bytes everywhere. Parts
// that are missing (renderer/cost/report.hpp says how) are told in words.
#pragma once

#include <string>

#include "renderer/cost/report.hpp"
#include "tools/driver/report/diagnostic_json.hpp"
#include "tools/driver/report/reporter.hpp"

namespace cobble::driver {

/// Tables that fit 100 columns, and the recommendation at the end, where a terminal leaves it.
std::string cost_to_text(const renderer::CostReport& report, const ReportStyle& style);

/// {"cobble_cost": 1, "path": P, "size": [w, h], "threads", "seed", "study_seconds",
/// "pixels_per_degree", "curve", "effects", "noise", "precision", "biases", "rungs",
/// "recommendation"}. Fields have the names of the records; intervals are [low, high]; a part, a
/// number or an interval that was not measured is null. Pictures are left out.
Json cost_to_json(const renderer::CostReport& report);

/// Error over time on logarithmic axes, as an SVG file: the curve with its 95 % band, what
/// independent samples would give, and the choices, those on the front with their names.
std::string cost_to_svg(const renderer::CostReport& report);

/// What share of the time and of the noise each effect has, as an SVG file.
std::string cost_shares_to_svg(const renderer::CostReport& report);

/// All of it as one HTML page that needs nothing but itself: charts and pictures are inside. A
/// picture costs what its PNG takes, and a third more.
std::string cost_to_html(const renderer::CostReport& report);

}  // namespace cobble::driver
