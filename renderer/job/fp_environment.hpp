// SPDX-License-Identifier: MIT
// The floating-point mode that every result assumes, whatever the host program runs in.
#pragma once

#include <cfenv>
#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace cobble::renderer {

/// While it lives, on this thread: round to nearest, denormals kept (flush-to-zero and
/// denormals-are-zero off), no traps. What was set before comes back when it dies. Some hosts turn
/// flushing on for a whole process, and new threads do not always inherit it: each task holds one.
class FpEnvironment {
  public:
    FpEnvironment() : rounding_(std::fegetround()) {
        std::fesetround(FE_TONEAREST);
#if defined(__SSE2__)
        control_ = _mm_getcsr();
        // Intel SDM volume 1, 10.2.3: bits 7-12 mask the exceptions, 13-14 rounding, 15 flush to
        // zero, 6 denormals are zero; this is the value after reset.
        _mm_setcsr(0x1f80U);
#elif defined(__aarch64__)
        asm volatile("mrs %0, fpcr" : "=r"(control_));
        asm volatile("msr fpcr, %0" ::"r"(std::uint64_t{0}));  // Arm ARM, FPCR: all modes default
#endif
    }
    FpEnvironment(const FpEnvironment&) = delete;
    FpEnvironment& operator=(const FpEnvironment&) = delete;
    ~FpEnvironment() {
#if defined(__SSE2__)
        _mm_setcsr(control_);
#elif defined(__aarch64__)
        asm volatile("msr fpcr, %0" ::"r"(control_));
#endif
        if (rounding_ >= 0) std::fesetround(rounding_);
    }

  private:
    int rounding_;
#if defined(__SSE2__)
    std::uint32_t control_ = 0;
#elif defined(__aarch64__)
    std::uint64_t control_ = 0;
#endif
};

}  // namespace cobble::renderer
