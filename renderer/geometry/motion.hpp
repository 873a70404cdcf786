// SPDX-License-Identifier: MIT
// Between the keys of a moving thing.
#pragma once

#include <cstdint>

namespace cobble::renderer {

/// The segment that `time` falls into: state = key[index] + fraction (key[index + 1] - key[index]),
/// and the very bits of a key where the time is the key's.
template <typename T>
struct Segment {
    std::uint32_t index;
    T fraction;  ///< in [0, 1); 0: take key[index] itself
};

/// `keys` >= 1 states at equal steps of time from 0 to 1. Times outside (NaN included) count as the
/// nearer end.
template <typename T>
Segment<T> segment_at(std::uint32_t keys, T time) {
    const std::uint32_t last = keys - 1;
    if (!(time > 0)) return {0, 0};
    if (!(time < 1)) return {last, 0};
    const T s = time * static_cast<T>(last);
    const auto index = static_cast<std::uint32_t>(s);
    return {index, s - static_cast<T>(index)};
}

}  // namespace cobble::renderer
