// SPDX-License-Identifier: MIT
#include "renderer/job/build_on.hpp"

#include <cstddef>
#include <functional>

#include "renderer/job/fp_environment.hpp"

namespace cobble::renderer {

BuildControl build_on(Scheduler& scheduler, const std::atomic<bool>* cancelled) {
    const auto parallel = [&scheduler](std::size_t count,
                                       const std::function<void(std::size_t)>& work) {
        std::atomic<std::size_t> next{0};
        scheduler.run([&](std::uint32_t) {
            const FpEnvironment environment;
            for (;;) {
                const std::size_t i = next.fetch_add(1, std::memory_order_relaxed);
                if (i >= count) return;
                work(i);
            }
        });
    };
    return {cancelled, parallel};
}

}  // namespace cobble::renderer
