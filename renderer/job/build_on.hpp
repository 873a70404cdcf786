// SPDX-License-Identifier: MIT
// Trees built by all workers of a scheduler.
#pragma once

#include <atomic>

#include "renderer/accel/build_control.hpp"
#include "renderer/job/scheduler.hpp"

namespace cobble::renderer {

/// Refers to both, which must outlive what is built. Not while the scheduler runs anything else.
BuildControl build_on(Scheduler& scheduler, const std::atomic<bool>* cancelled = nullptr);

}  // namespace cobble::renderer
