// SPDX-License-Identifier: MIT
#include "tools/cobble/interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string_view>

#include "renderer/job/render_job.hpp"
#include "tools/cobble/command.hpp"

namespace cobble {
namespace {

// Signal handlers may touch lock-free atomics only.
std::atomic<bool> guarded{false};
std::atomic<bool> caught{false};
std::atomic<renderer::RenderJob*> guarded_job{nullptr};
static_assert(std::atomic<renderer::RenderJob*>::is_always_lock_free);

extern "C" void handle_interrupt(int /*signal*/) {
    if (!guarded || caught.exchange(true)) {
        constexpr std::string_view kMessage = "\ncobble: interrupted\n";
        // If this cannot be said, there is nobody to say it to.
        if (write(STDERR_FILENO, kMessage.data(), kMessage.size()) < 0) _exit(kInterrupted);
        _exit(kInterrupted);
    }
    if (renderer::RenderJob* job = guarded_job) job->cancel();
}

}  // namespace

void exit_on_interrupt() {
    struct sigaction action {};
    action.sa_handler = handle_interrupt;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        // A shell script's background job has SIGINT ignored, nohup SIGHUP, and that is to stay so.
        struct sigaction old {};
        if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_IGN) continue;
        sigaction(signal, &action, nullptr);
    }
}

InterruptGuard::InterruptGuard(renderer::RenderJob* job) {
    guarded_job = job;
    guarded = true;
    // An interrupt between two guards is one of this job too.
    if (caught && job != nullptr) job->cancel();
}

InterruptGuard::~InterruptGuard() {
    guarded = false;
    guarded_job = nullptr;
}

bool InterruptGuard::interrupted() { return caught; }

}  // namespace cobble
