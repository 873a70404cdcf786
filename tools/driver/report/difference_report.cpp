// SPDX-License-Identifier: MIT
#include "tools/driver/report/difference_report.hpp"

#include <fmt/core.h>

#include "tools/driver/report/diagnostic_json.hpp"

namespace cobble::driver {
namespace {

std::uint64_t pixels_of(const DifferenceReport& report) {
    return std::uint64_t{report.width} * report.height;
}

}  // namespace

std::string difference_to_text(const DifferenceReport& report) {
    const renderer::Comparison& c = report.comparison;
    const std::uint64_t pixels = pixels_of(report);
    // Where no pixel is finite in both, nothing was compared.
    const auto number = [any = c.not_finite < pixels](double value) {
        return any ? fmt::format("{:.9g}", value) : std::string("-");
    };
    std::string text = fmt::format(
        "MSE              {}\n"
        "relMSE           {}\n"
        "MAE              {}\n"
        "maximum          {}\n"
        "99th percentile  {}\n"
        "FLIP             {:.9g} (maximum {:.9g}; {:g} pixels per degree)\n"
        "differing        {} of {} pixels\n",
        number(c.mse), number(c.rel_mse), number(c.mae), number(c.maximum), number(c.percentile_99),
        c.flip, c.flip_maximum, c.pixels_per_degree, c.differing, pixels);
    if (report.tolerance) {
        text += fmt::format("beyond tolerance {} of {} pixels (by more than {:g})\n",
                            c.beyond_tolerance, pixels, *report.tolerance);
    }
    if (c.clamped > 0) text += fmt::format("clamped for FLIP {} values\n", c.clamped);
    if (c.not_finite > 0)
        text += fmt::format("not finite       {} pixels, left out\n", c.not_finite);
    return text;
}

std::string difference_to_json(const DifferenceReport& report) {
    const renderer::Comparison& c = report.comparison;
    const auto if_any = [&report](const auto& value) {
        return report.tolerance ? Json(value) : Json();
    };
    const auto number = [any = c.not_finite < pixels_of(report)](double value) {
        return any ? Json(value) : Json();
    };
    return pretty({{"cobble_diff", 1},
                   {"a", report.a},
                   {"b", report.b},
                   {"width", report.width},
                   {"height", report.height},
                   {"mse", number(c.mse)},
                   {"rel_mse", number(c.rel_mse)},
                   {"mae", number(c.mae)},
                   {"maximum", number(c.maximum)},
                   {"percentile_99", number(c.percentile_99)},
                   {"flip",
                    {{"mean", c.flip},
                     {"maximum", c.flip_maximum},
                     {"pixels_per_degree", c.pixels_per_degree}}},
                   {"pixels",
                    {{"all", pixels_of(report)},
                     {"differing", c.differing},
                     {"not_finite", c.not_finite},
                     {"beyond_tolerance", if_any(c.beyond_tolerance)}}},
                   {"clamped_values", c.clamped},
                   {"tolerance", if_any(report.tolerance.value_or(0))},
                   {"within_tolerance", if_any(report.within_tolerance())}});
}

}  // namespace cobble::driver
