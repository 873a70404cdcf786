// SPDX-License-Identifier: MIT
// Ctrl-C. At first an interrupt ends the process at once, as there is nothing to save; work that
// leaves something behind takes over with an InterruptGuard.
#pragma once

namespace cobble::renderer {
class RenderJob;
}

namespace cobble {

/// From now on SIGINT, SIGTERM and SIGHUP end the process with status 130.
void exit_on_interrupt();

/// While one lives, these signals only set a flag, and cancel the job if there is one. A
/// second signal ends the process at once.
class InterruptGuard {
  public:
    explicit InterruptGuard(renderer::RenderJob* job = nullptr);
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    ~InterruptGuard();

    [[nodiscard]] static bool interrupted();
};

}  // namespace cobble
