// SPDX-License-Identifier: MIT
// Time as it passes, and as processors spend it on us: the latter does not count what other
// programs take on a shared machine.
#pragma once

#include <ctime>

namespace cobble::bench {

inline double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Starts when it is made.
class Stopwatch {
  public:
    [[nodiscard]] double wall_seconds() const { return seconds_of(CLOCK_MONOTONIC) - wall_; }
    /// Of all threads together.
    [[nodiscard]] double process_seconds() const {
        return seconds_of(CLOCK_PROCESS_CPUTIME_ID) - process_;
    }
    /// Of the thread that asks; it must be the one that made the watch.
    [[nodiscard]] double thread_seconds() const {
        return seconds_of(CLOCK_THREAD_CPUTIME_ID) - thread_;
    }

  private:
    double wall_ = seconds_of(CLOCK_MONOTONIC);
    double process_ = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
    double thread_ = seconds_of(CLOCK_THREAD_CPUTIME_ID);
};

}  // namespace cobble::bench
