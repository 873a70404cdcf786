// SPDX-License-Identifier: MIT
// Whole numbers in the bytes of picture files, in either order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cobble::image {

/// 0 for a byte that is not there.
inline std::uint64_t byte_at(std::string_view bytes, std::size_t at) {
    return at < bytes.size() ? static_cast<std::uint8_t>(bytes[at]) : 0;
}

/// `count` bytes, at most 8, from `at` on: the lowest first, or the highest. Bytes that are not
/// there count as 0.
inline std::uint64_t little_endian(std::string_view bytes, std::size_t at, unsigned count) {
    std::uint64_t value = 0;
    for (unsigned i = 0; i < count; ++i) value |= byte_at(bytes, at + i) << (8 * i);
    return value;
}
inline std::uint64_t big_endian(std::string_view bytes, std::size_t at, unsigned count) {
    std::uint64_t value = 0;
    for (unsigned i = 0; i < count; ++i) value = value << 8 | byte_at(bytes, at + i);
    return value;
}

/// Appends the lowest `count` bytes of `value`, at most 8.
inline void put_little_endian(std::string& out, std::uint64_t value, unsigned count) {
    for (unsigned i = 0; i < count; ++i) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
}
inline void put_big_endian(std::string& out, std::uint64_t value, unsigned count) {
    for (unsigned i = count; i-- > 0;) out.push_back(static_cast<char>(value >> (8 * i) & 0xff));
}

}  // namespace cobble::image
