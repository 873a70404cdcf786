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

    /// `work_done`: any growing count of about 10 ns each (box and primitive tests). The first ask
    /// of all is granted unless cancelled, so that every step gets somewhere, however late it is.
    [[nodiscard]] bool operator()(std::uint64_t work_done) {
        if (stopped_) return true;
        if (cancelled_->load(std::memory_order_relaxed)) return stopped_ = true;
        if (!asked_before_) {
            asked_before_ = true;
            last_look_ = work_done;
            return false;
        }
        if (work_done - last_look_ < kWorkBetweenLooks && ++asks_ < kAsksBetweenLooks) return false;
        last_look_ = work_done;
        asks_ = 0;
        return stopped_ = std::chrono::steady_clock::now() >= deadline_;
    }

    /// For work whose cost is not known: reads the clock (but for the first ask of all).
    [[nodiscard]] bool now() { return (*this)(last_look_ + kWorkBetweenLooks); }

    /// Between stages of a batch, of which the core's take 2 ms at most and of the others one in
    /// three, 128 surfaces of at most 20 us each, 2.6 ms. Looks at every fifth, or once 16,000
    /// tests were done since the last look: a step then overruns by less than 8 ms.
    [[nodiscard]] bool between_stages(std::uint64_t tests_done) {
        return (*this)(tests_done / 16 + kWorkBetweenLooks / 5 * ++stages_);
    }

  private:
    /// 1000 tests of 10 ns are 10 us, and 64 shaded rays of at most 20 us are 1.3 ms: both far
    /// below the 10 ms by which a step may overrun.
    static constexpr std::uint64_t kWorkBetweenLooks = 1000;
    static constexpr std::uint32_t kAsksBetweenLooks = 64;

    const std::atomic<bool>* cancelled_;
    Deadline deadline_;
    std::uint64_t last_look_ = 0;
    std::uint64_t stages_ = 0;
    std::uint32_t asks_ = 0;
    bool asked_before_ = false;
    bool stopped_ = false;
};

}  // namespace cobble::renderer
