// SPDX-License-Identifier: MIT
#include "tools/cobble/progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "tools/driver/output.hpp"

namespace cobble {
namespace {

constexpr std::chrono::milliseconds kRedraw{100};
constexpr std::chrono::seconds kBetweenLines{1};
// Longer bars tell nothing more.
constexpr unsigned kMaxBar = 40;

std::string facts(double fraction, std::uint64_t rays, double seconds) {
    std::string text = fmt::format("{:3.0f} %", std::floor(fraction * 100));
    if (seconds <= 0) return text;
    text += fmt::format("  {}rays/s", short_number(static_cast<double>(rays) / seconds));
    // The first hundredth says too little about the rest.
    if (fraction >= 0.01 && fraction < 1) {
        text += fmt::format("  {} left", clock_text(seconds * (1 - fraction) / fraction));
    }
    return text;
}

}  // namespace

std::string short_number(double value) {
    constexpr const char* kSteps[] = {" ", " k", " M", " G", " T"};
    std::size_t step = 0;
    while (value >= 999.5 && step + 1 < std::size(kSteps)) {
        value /= 1000;
        ++step;
    }
    const int decimals = step == 0 || value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
    return fmt::format("{:.{}f}{}", value, decimals, kSteps[step]);
}

std::string clock_text(double seconds) {
    const auto whole = static_cast<std::uint64_t>(std::min(std::ceil(seconds), 3.6e8));
    const std::uint64_t hours = whole / 3600;
    if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

void ProgressBar::show(double fraction, std::uint64_t rays, double seconds) {
    const auto now = Clock::now();
    if (kind_ == Kind::kSilent || now < next_) return;
    const std::string text = facts(fraction, rays, seconds);
    if (kind_ == Kind::kLines) {
        const int tenths = static_cast<int>(fraction * 10);
        if (tenths <= tenths_ || tenths >= 10) return;
        tenths_ = tenths;
        next_ = now + kBetweenLines;
        driver::write_error(fmt::format("rendering: {}\n", text));
        return;
    }
    next_ = now + kRedraw;
    const unsigned room = columns_ > text.size() + 4 ? columns_ - unsigned(text.size()) - 4 : 0;
    const unsigned bar = std::min(room, kMaxBar);
    const auto full = static_cast<unsigned>(fraction * bar);
    const std::string line = bar < 5 ? text
                                     : fmt::format("[{}{}] {}", std::string(full, '#'),
                                                   std::string(bar - full, '.'), text);
    // Back to the start of the line, draw, and clear what an older line left behind.
    driver::write_error("\r" + line + "\x1b[K");
    drawn_ = true;
}

void ProgressBar::clear() {
    if (drawn_) driver::write_error("\r\x1b[K");
    drawn_ = false;
}

}  // namespace cobble
