// SPDX-License-Identifier: MIT
#include <exception>

#include "renderer/job/scheduler.hpp"

namespace cobble::renderer {
namespace {

struct Finished final : Background {
    bool wait_until(std::chrono::steady_clock::time_point) override {
        if (failure) std::rethrow_exception(failure);
        return true;
    }

    std::exception_ptr failure;
};

class SerialScheduler final : public Scheduler {
  public:
    [[nodiscard]] std::uint32_t workers() const override { return 1; }
    void run(const std::function<void(std::uint32_t)>& work) override { work(0); }
    std::unique_ptr<Background> start(std::function<void()> work) override {
        auto finished = std::make_unique<Finished>();
        try {
            work();
        } catch (...) {
            finished->failure = std::current_exception();
        }
        return finished;
    }
};

}  // namespace

std::unique_ptr<Scheduler> make_serial_scheduler() { return std::make_unique<SerialScheduler>(); }

}  // namespace cobble::renderer
