// SPDX-License-Identifier: MIT
// Bits for tests, the same everywhere: SplitMix64 (Steele, Lea and Flood: Fast splittable
// pseudorandom number generators, OOPSLA 2014).
#pragma once

#include <cstdint>

namespace cobble::test {

class SplitMix64 {
  public:
    explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        return z ^ (z >> 31U);
    }

    /// In [0, n), 0 for n = 0; the bias for small n does not matter in tests.
    std::uint64_t below(std::uint64_t n) { return n == 0 ? 0 : bits() % n; }

  private:
    std::uint64_t state_;
};

}  // namespace cobble::test
