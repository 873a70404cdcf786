// SPDX-License-Identifier: MIT
#include <exception>
#include <utility>

#include "renderer/job/scheduler.hpp"

namespace cobble::renderer {
namespace {

class Finished final : public Background {
  public:
    explicit Finished(std::exception_ptr failure) : failure_(std::move(failure)) {}
    bool wait_until(std::chrono::steady_clock::time_point) override {
        if (failure_) std::rethrow_exception(failure_);
        return true;
    }

  private:
    std::exception_ptr failure_;
};

class SerialScheduler final : public Scheduler {
  public:
    [[nodiscard]] std::uint32_t workers() const override { return 1; }
    void run(const std::function<void(std::uint32_t)>& work) override { work(0); }
    std::unique_ptr<Background> start(std::function<void()> work) override {
        std::exception_ptr failure;
        try {
            work();
        } catch (...) {
            failure = std::current_exception();
        }
        return std::make_unique<Finished>(std::move(failure));
    }
};

}  // namespace

std::unique_ptr<Scheduler> make_serial_scheduler() { return std::make_unique<SerialScheduler>(); }

}  // namespace cobble::renderer
