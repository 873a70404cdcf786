// SPDX-License-Identifier: MIT
#include "renderer/job/scheduler.hpp"

namespace cobble::renderer {
namespace {

class Finished final : public Background {
  public:
    bool wait_until(std::chrono::steady_clock::time_point) override { return true; }
};

class SerialScheduler final : public Scheduler {
  public:
    [[nodiscard]] std::uint32_t workers() const override { return 1; }
    void run(const std::function<void(std::uint32_t)>& work) override { work(0); }
    std::unique_ptr<Background> start(std::function<void()> work) override {
        work();
        return std::make_unique<Finished>();
    }
};

}  // namespace

std::unique_ptr<Scheduler> make_serial_scheduler() { return std::make_unique<SerialScheduler>(); }

}  // namespace cobble::renderer
