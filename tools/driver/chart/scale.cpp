// SPDX-License-Identifier: MIT
#include "tools/driver/chart/scale.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ir/math/elementary.hpp"

namespace cobble::driver::chart {
namespace {

constexpr double kLn10 = 2.302585092994046;
// Of the axis at each end: marks at the extremes do not touch the frame.
constexpr double kRoom = 0.06;
// Labels beyond so many would touch.
constexpr int kMostDecades = 8;
// Up to so many, there is room for two labels between.
constexpr int kFewDecades = 3;
// Lines at all decades between are a grey haze beyond so many a label.
constexpr int kMostBetween = 4;
constexpr double kMostShareTicks = 8;
constexpr double kShareRoom = 0.02;
// Ten thousand per cent: what is beyond ends at the end of the axis.
constexpr double kMostShare = 100;
// A ten-millionth of a decade: what rounding may take from a tick that ends the axis.
constexpr double kSlack = 1e-7;

// Of our own, for the same bits everywhere.
double log10_of(double value) { return math::log(value) / kLn10; }

constexpr std::string_view kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

std::string raised(int number) {
    std::string text = number < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(number))) text += kRaised[digit - '0'];
    return text;
}

}  // namespace

bool has_place(double value) { return std::isfinite(value) && value > 0; }

std::string power_text(int digit, int exponent) {
    const std::string digits = std::to_string(digit);
    if (exponent >= 0 && exponent <= 5) {
        return digits + std::string(static_cast<std::size_t>(exponent), '0');
    }
    if (exponent < 0 && exponent >= -4) {
        return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
    }
    return (digit == 1 ? "" : digits + "×") + "10" + raised(exponent);
}

LogScale::LogScale(std::span<const double> values) {
    bool any = false;
    for (const double value : values) {
        if (!has_place(value)) continue;
        const double at = log10_of(value);
        low_ = any ? std::min(low_, at) : at;
        high_ = any ? std::max(high_, at) : at;
        any = true;
    }
    if (!any) return;
    const double missing = std::max(1 - (high_ - low_), 0.0);
    const double room = missing / 2 + kRoom * std::max(high_ - low_, 1.0);
    low_ -= room;
    high_ += room;
}

double LogScale::unit(double value) const {
    if (!(value > 0)) return 0;
    return std::clamp((log10_of(value) - low_) / (high_ - low_), 0.0, 1.0);
}

std::vector<Tick> LogScale::ticks() const {
    std::vector<Tick> ticks;
    const int first = static_cast<int>(std::floor(low_));
    const int last = static_cast<int>(std::floor(high_ + kSlack));
    const int decades = last - static_cast<int>(std::ceil(low_ - kSlack)) + 1;
    const int every = (decades + kMostDecades - 1) / kMostDecades;
    for (int exponent = first; exponent <= last; ++exponent) {
        const bool counted = every <= 1 || exponent % every == 0;
        if (every > kMostBetween && !counted) continue;
        for (int digit = 1; digit <= (every > 1 ? 1 : 9); ++digit) {
            const double at = exponent + log10_of(digit);
            if (at < low_ - kSlack || at > high_ + kSlack) continue;
            const bool labelled =
                digit == 1 ? counted : decades <= kFewDecades && (digit == 2 || digit == 5);
            ticks.push_back({std::clamp((at - low_) / (high_ - low_), 0.0, 1.0),
                             labelled ? power_text(digit, exponent) : ""});
        }
    }
    return ticks;
}

ShareScale::ShareScale(std::span<const double> values) {
    double low = 0;
    double high = 0;
    for (const double value : values) {
        if (!(std::abs(value) <= kMostShare)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    // Nothing, or next to nothing: an axis to one per cent.
    if (high - low < 0.01) high = low + 0.01;
    const double decade = math::pow(10, std::floor(log10_of(high - low)));
    for (const double digit : {0.1, 0.2, 0.5, 1.0, 2.0}) {
        step_ = digit * decade;
        if ((high - low) / step_ <= kMostShareTicks) break;
    }
    low_ = low < 0 ? low - kShareRoom * (high - low) : 0;
    high_ = std::ceil(high / step_ - kSlack) * step_;
}

double ShareScale::unit(double value) const {
    if (std::isnan(value)) value = 0;
    return std::clamp((value - low_) / (high_ - low_), 0.0, 1.0);
}

std::vector<Tick> ShareScale::ticks() const {
    std::vector<Tick> ticks;
    const int first = static_cast<int>(std::ceil(low_ / step_ - kSlack));
    const int last = static_cast<int>(std::lround(high_ / step_));
    for (int i = first; i <= last; ++i) {
        const double percent = i * step_ * 100;
        ticks.push_back({unit(i * step_), fmt::format("{:.{}f} %", i == 0 ? 0 : percent,
                                                      step_ * 100 < 0.999 ? 1 : 0)});
    }
    return ticks;
}

}  // namespace cobble::driver::chart
