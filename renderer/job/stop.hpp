// SPDX-License-Identifier: MIT
// When to put work down: at a deadline, or at once if the job is cancelled.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace cobble::renderer {

using Deadline = std::chrono::steady_clock::time_point;

/// Asked by workers between units of work, one object a worker. Reading the clock costs about as
/// much as twenty box tests, so it is read only when that much work was done since the last look;
/// the cancel flag is read every time. Once true, true for good.
class StopCheck {
  public:
    StopCheck(const std::atomic<bool>& cancelled, Deadline deadline)
        : cancelled_(&cancelled), deadline_(deadline) {}

    /// `work_done`: any growing count of about 10 ns each (box and primitive tests).
    [[nodiscard]] bool operator()(std::uint64_t work_done) {
        if (stopped_) return true;
        if (cancelled_->load(std::memory_order_relaxed)) return stopped_ = true;
        if (work_done - last_look_ < kWorkBetweenLooks && ++asked_ < kAsksBetweenLooks)
            return false;
        return look(work_done);
    }

    /// Cancelled or past the deadline as of now, the clock read.
    [[nodiscard]] bool now() { return (*this)(last_look_ + kWorkBetweenLooks); }

  private:
    bool look(std::uint64_t work_done) {
        last_look_ = work_done;
        asked_ = 0;
        return stopped_ = std::chrono::steady_clock::now() >= deadline_;
    }

    /// 1000 tests of 10 ns are 10 us, and 64 shaded rays of at most 20 us are 1.3 ms: both far
    /// below the 10 ms by which a step may overrun.
    static constexpr std::uint64_t kWorkBetweenLooks = 1000;
    static constexpr std::uint32_t kAsksBetweenLooks = 64;

    const std::atomic<bool>* cancelled_;
    Deadline deadline_;
    std::uint64_t last_look_ = 0;
    std::uint32_t asked_ = 0;
    bool stopped_ = false;
};

}  // namespace cobble::renderer
