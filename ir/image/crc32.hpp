// SPDX-License-Identifier: MIT
// The checksum of PNG's chunks.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cobble::image {

inline constexpr auto kCrcTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
        std::uint32_t c = n;
        for (int k = 0; k < 8; ++k) c = (c & 1) != 0 ? 0xedb88320U ^ (c >> 1) : c >> 1;
        table[n] = c;
    }
    return table;
}();

/// CRC-32 of ISO 3309, the polynomial reflected: PNG specification, annex D.
constexpr std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t c = 0xffffffffU;
    for (const char byte : bytes) {
        c = kCrcTable[(c ^ static_cast<std::uint8_t>(byte)) & 255] ^ (c >> 8);
    }
    return c ^ 0xffffffffU;
}
static_assert(crc32("IEND") == 0xae426082);

}  // namespace cobble::image
