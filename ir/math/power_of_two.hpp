// SPDX-License-Identifier: MIT
// Powers of two, exact and without the C library.
#pragma once

#include <bit>
#include <cstdint>

namespace cobble::math {

/// 2^k, for k in [-1022, 1023].
inline double power_of_two(int k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

}  // namespace cobble::math
