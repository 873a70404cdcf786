// SPDX-License-Identifier: MIT
#include "renderer/job/scheduler.hpp"

namespace cobble::renderer {
namespace {

class SerialScheduler final : public Scheduler {
  public:
    [[nodiscard]] std::uint32_t workers() const override { return 1; }
    void run(const std::function<void(std::uint32_t)>& work) override { work(0); }
};

}  // namespace

std::unique_ptr<Scheduler> make_serial_scheduler() { return std::make_unique<SerialScheduler>(); }

}  // namespace cobble::renderer
