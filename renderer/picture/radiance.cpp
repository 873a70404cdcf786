// SPDX-License-Identifier: MIT
// Radiance pictures, as ir/image/radiance.hpp describes them.
#include <fmt/format.h>

#include <array>
#include <bit>

#include "ir/math/power_of_two.hpp"
#include "renderer/picture/codecs.hpp"

namespace cobble::renderer {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// Rounds to the nearest mantissas; the largest lies in [128, 255].
Rgbe rgbe_of(const std::array<float, 3>& color) {
    std::array<double, 3> value{};
    double largest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        // NaN and what is negative become 0; the format ends below 2^127.
        const auto v = static_cast<double>(color[c]);
        value[c] = v > 0 ? (v < 0x1.fdp126 ? v : 0x1.fdp126) : 0;
        if (value[c] > largest) largest = value[c];
    }
    if (largest < 0x1p-127) return {};  // below the smallest exponent
    // The exponent field of a positive double: largest is in [2^(e-1), 2^e).
    int e = static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> 52) - 1022;
    if (largest * math::power_of_two(8 - e) + 0.5 >= 256) ++e;
    Rgbe result{};
    for (std::size_t c = 0; c < 3; ++c) {
        result[c] = static_cast<std::uint8_t>(value[c] * math::power_of_two(8 - e) + 0.5);
    }
    result[3] = static_cast<std::uint8_t>(e + 128);
    return result;
}

}  // namespace

Encoded encode_hdr(const Plane32& plane) {
    Encoded result;
    result.bytes = fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", plane.height,
                               plane.width);
    const std::size_t pixels = std::size_t{plane.width} * plane.height;
    result.bytes.reserve(result.bytes.size() + pixels * 4);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float* p = &plane.values[i * plane.channels];
        const bool grey = plane.channels == 1;
        // Rows without run lengths cannot be taken for others: the largest mantissa of a pixel that
        // is not black is at least 128, and both codes' marks have three or two small ones.
        for (const std::uint8_t byte : rgbe_of({p[0], p[grey ? 0 : 1], p[grey ? 0 : 2]})) {
            result.bytes.push_back(static_cast<char>(byte));
        }
    }
    return result;
}

}  // namespace cobble::renderer
