// SPDX-License-Identifier: MIT
// Integer hashes behind every random number: no state, so that a number depends on nothing but its
// key.
#pragma once

#include <cstdint>

namespace cobble::renderer {

/// A bijection of 64 bits in which every input bit changes half the output bits (the finaliser of
/// SplitMix64, variant 13 of Stafford's constants; Steele, Lea and Flood, OOPSLA 2014).
constexpr std::uint64_t mix64(std::uint64_t x) {
    x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31U);
}

/// Order matters: combine(a, b) and combine(b, a) are unrelated.
constexpr std::uint64_t combine(std::uint64_t seed, std::uint64_t value) {
    constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio, as SplitMix64
    return mix64(seed + kGolden + mix64(value + kGolden));
}

}  // namespace cobble::renderer
