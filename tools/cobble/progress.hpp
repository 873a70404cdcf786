// SPDX-License-Identifier: MIT
// How far a render is, for a person who waits.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace cobble {

/// "950", "12.3 k", "4.56 M", "1.2 G": three digits are enough for a rate.
std::string short_number(double value);

/// "0:42", "12:05", "1:02:03".
std::string clock_text(double seconds);

/// On a terminal one line that is drawn anew ten times a second; elsewhere a line for each tenth of
/// the work, but none more often than once a second. Silent if told so.
class ProgressBar {
  public:
    enum class Kind : unsigned char { kSilent, kLines, kTerminal };

    ProgressBar(Kind kind, unsigned columns) : kind_(kind), columns_(columns) {}

    /// `fraction` in [0, 1], `rays` traced so far, in `seconds`.
    void show(double fraction, std::uint64_t rays, double seconds);
    /// Takes the bar off the terminal.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    Kind kind_;
    unsigned columns_;
    bool drawn_ = false;
    int tenths_ = 0;
    Clock::time_point next_ = Clock::now();
};

}  // namespace cobble
