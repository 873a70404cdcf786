// SPDX-License-Identifier: MIT
// The one place that knows about threads.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>

namespace cobble::renderer {

/// Work that goes on beside whoever started it. Destroying it waits for its end.
class Background {
  public:
    Background() = default;
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    virtual ~Background() = default;

    /// Waits until the work has ended, then true, or until `deadline`, then false. What the work
    /// wrote may be read once this was true. Throws what the work threw.
    virtual bool wait_until(std::chrono::steady_clock::time_point deadline) = 0;
};

/// Runs one function on all workers at once and waits for them.
class Scheduler {
  public:
    Scheduler() = default;
    Scheduler(const Scheduler&) = delete;
    Scheduler& operator=(const Scheduler&) = delete;
    virtual ~Scheduler() = default;

    [[nodiscard]] virtual std::uint32_t workers() const = 0;
    /// Calls work(worker) once for each worker in [0, workers()), concurrently, and returns when
    /// all have returned. What any of them threw (memory that ran out) is then thrown here, on the
    /// caller's thread; if several did, that of the lowest worker.
    virtual void run(const std::function<void(std::uint32_t worker)>& work) = 0;
    /// Calls work() once, beside the caller if there are threads for that, else before this
    /// returns.
    virtual std::unique_ptr<Background> start(std::function<void()> work) = 0;
};

/// Everything on the caller's thread: for a browser, and for tests.
std::unique_ptr<Scheduler> make_serial_scheduler();

/// `threads` workers (0: one a processor), the caller's thread among them.
std::unique_ptr<Scheduler> make_thread_scheduler(std::uint32_t threads);

}  // namespace cobble::renderer
