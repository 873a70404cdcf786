// SPDX-License-Identifier: MIT
#include "tools/driver/report/figures.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string_view>

namespace cobble::driver {
namespace {

constexpr std::string_view kNothing = "-";

}  // namespace

std::string figure(double value) {
    if (!std::isfinite(value)) return std::string(kNothing);
    const double size = std::abs(value);
    if (size == 0) return "0";
    if (size < 1e-4 || size >= 1e6) return fmt::format("{:.2e}", value);
    int decimals = 0;
    for (double limit = 100; decimals < 6 && size < limit; limit /= 10) ++decimals;
    return fmt::format("{:.{}f}", value, decimals);
}

std::string percent(double share) {
    if (!std::isfinite(share)) return std::string(kNothing);
    const std::string text = fmt::format("{:.1f}", share * 100);
    return (text == "-0.0" ? "0.0" : text) + " %";
}

std::string interval(double low, double high) {
    if (!std::isfinite(low) || !std::isfinite(high)) return std::string(kNothing);
    return figure(low) + " to " + figure(high);
}

std::string percent_interval(double low, double high) {
    if (!std::isfinite(low) || !std::isfinite(high)) return std::string(kNothing);
    return fmt::format("{:.1f} to {:.1f} %", 100 * low, 100 * high);
}

std::string counted(std::uint64_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string count_figure(std::int64_t count) {
    if (count < 0) return '-' + count_figure(-count);
    constexpr std::string_view kUnits[] = {"k", "M", "G", "T", "P", "E"};
    if (count < 10000) return std::to_string(count);
    double value = static_cast<double>(count) / 1000;
    std::size_t unit = 0;
    while (value >= 999.5 && unit + 1 < std::size(kUnits)) {
        value /= 1000;
        ++unit;
    }
    return figure(value) + ' ' + std::string(kUnits[unit]);
}

}  // namespace cobble::driver
