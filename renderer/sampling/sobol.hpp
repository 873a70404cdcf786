// SPDX-License-Identifier: MIT
// Owen-scrambled Sobol points, shuffled, each set from one seed (Burley, "Practical Hash-based
// Owen Scrambling", JCGT 9(4), 2020).
//
// Any power-of-two stretch of indices beginning at a multiple of itself is stratified in both
// coordinates and together: a (0, m, 2)-net. Sets of different seeds are independent, which is what
// lets each effect own one ("padding").
#pragma once

#include <cstdint>

namespace cobble::renderer {

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
    x = (x >> 16U) | (x << 16U);
    x = ((x & 0xff00ff00U) >> 8U) | ((x & 0x00ff00ffU) << 8U);
    x = ((x & 0xf0f0f0f0U) >> 4U) | ((x & 0x0f0f0f0fU) << 4U);
    x = ((x & 0xccccccccU) >> 2U) | ((x & 0x33333333U) << 2U);
    return ((x & 0xaaaaaaaaU) >> 1U) | ((x & 0x55555555U) << 1U);
}

/// Constants of Burley's paper.
inline constexpr std::uint32_t kLaineKarras[] = {0x6c50b47cU, 0xb82f1e52U, 0xc7afe638U,
                                                 0x8d22f6e6U};

/// A permutation of 32-bit numbers in which each bit's fate depends on lower bits only (Laine and
/// Karras, EGSR 2011).
constexpr std::uint32_t laine_karras(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    for (const std::uint32_t factor : kLaineKarras) x ^= x * factor;
    return x;
}

/// Owen's nested scramble in base 2 of a 0.32 fixed-point fraction.
constexpr std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) {
    return reverse_bits(laine_karras(reverse_bits(x), seed));
}

/// Pascal's triangle modulo 2 times the bits of x: bit j becomes the sum, modulo 2, of the bits k
/// for which C(k, j) is odd. It is odd where k has all the bits of j (Lucas, 1878): a sum over
/// supersets, one bit of the positions at a time.
constexpr std::uint32_t times_pascal(std::uint32_t x) {
    x ^= (x >> 1U) & 0x55555555U;
    x ^= (x >> 2U) & 0x33333333U;
    x ^= (x >> 4U) & 0x0f0f0f0fU;
    x ^= (x >> 8U) & 0x00ff00ffU;
    return x ^ (x >> 16U);
}

/// The second Sobol dimension (primitive polynomial x + 1): its direction numbers are the rows of
/// Pascal's triangle modulo 2, each the one before xor itself shifted by one. The first dimension
/// is the index with its bits reversed.
constexpr std::uint32_t sobol_second(std::uint32_t index) {
    return reverse_bits(times_pascal(index));
}

/// In [0, 1), multiples of 2^-32.
struct Uniform2 {
    double x = 0, y = 0;
};

constexpr double kTwoToMinus32 = 1.0 / 4294967296.0;

/// What the scrambles of one set begin with: of the order of its points, and of each coordinate.
struct SobolSeeds {
    std::uint32_t order = 0, x = 0, y = 0;
};

/// Of the set named by `seed`.
constexpr SobolSeeds sobol_seeds(std::uint64_t seed) {
    const auto low = static_cast<std::uint32_t>(seed);
    const auto high = static_cast<std::uint32_t>(seed >> 32U);
    // Three scrambles need three seeds; multiplying by odd constants (2^32 / golden ratio, and its
    // square) keeps them apart for every value of the high half.
    return {low, high, high * 0x9e3779b9U ^ (low * 0x61c88647U + 1U)};
}

/// The point whose index has these bits, the lowest first.
constexpr Uniform2 sobol_point_of_reversed(std::uint32_t index_reversed, SobolSeeds seeds) {
    // owen_scramble(index, ...).
    const std::uint32_t shuffled = reverse_bits(laine_karras(index_reversed, seeds.order));
    // owen_scramble(reverse_bits(shuffled), ...) and owen_scramble(sobol_second(shuffled), ...):
    // what their beginning reverses was reversed just before.
    const std::uint32_t x = reverse_bits(laine_karras(shuffled, seeds.x));
    const std::uint32_t y = reverse_bits(laine_karras(times_pascal(shuffled), seeds.y));
    return {x * kTwoToMinus32, y * kTwoToMinus32};
}

/// Point `index` of the set named by `seed`.
constexpr Uniform2 sobol_point(std::uint32_t index, std::uint64_t seed) {
    return sobol_point_of_reversed(reverse_bits(index), sobol_seeds(seed));
}

}  // namespace cobble::renderer
