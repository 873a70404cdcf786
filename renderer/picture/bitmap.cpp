// SPDX-License-Identifier: MIT
// BMP and TGA: uncompressed, rows from the bottom, blue first, as the published programs wrote
// them.
#include <array>

#include "ir/image/bytes.hpp"
#include "renderer/picture/codecs.hpp"

namespace cobble::renderer {
namespace {

using image::put_little_endian;

/// Blue, green, red from the bottom row up, each row filled to `row_bytes`.
void put_rows(std::string& out, const ByteImage& image, std::size_t row_bytes) {
    for (std::uint32_t row = image.height; row-- > 0;) {
        const std::size_t start = out.size();
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const std::size_t at = (std::size_t{row} * image.width + x) * image.channels;
            for (std::size_t c = 3; c-- > 0;) {
                out.push_back(image.bytes[at + (image.channels == 3 ? c : 0)]);
            }
        }
        out.resize(start + row_bytes);
    }
}

}  // namespace

Encoded encode_bmp(const ByteImage& image) {
    constexpr std::uint32_t kHeaders = 14 + 40;
    const std::size_t row = (std::size_t{image.width} * 3 + 3) / 4 * 4;
    const auto size = static_cast<std::uint32_t>(row * image.height);
    Encoded result;
    std::string& out = result.bytes;
    out.reserve(kHeaders + size);
    out += "BM";
    put_little_endian(out, kHeaders + size, 4);
    put_little_endian(out, 0, 4);
    put_little_endian(out, kHeaders, 4);
    put_little_endian(out, 40, 4);
    put_little_endian(out, image.width, 4);
    put_little_endian(out, image.height, 4);
    put_little_endian(out, 1, 2);   // planes
    put_little_endian(out, 24, 2);  // bits a pixel
    put_little_endian(out, 0, 4);   // uncompressed
    put_little_endian(out, size, 4);
    for (int i = 0; i < 4; ++i) put_little_endian(out, 0, 4);  // no resolution, no palette
    put_rows(out, image, row);
    return result;
}

Encoded encode_tga(const ByteImage& image) {
    Encoded result;
    std::string& out = result.bytes;
    const std::size_t row = std::size_t{image.width} * 3;
    out.reserve(18 + row * image.height);
    constexpr std::array<char, 12> kTrueColour{0, 0, 2};  // no palette, origin 0 0
    out.append(kTrueColour.data(), kTrueColour.size());
    put_little_endian(out, image.width, 2);
    put_little_endian(out, image.height, 2);
    out.push_back(24);
    out.push_back(0);  // rows from the bottom
    put_rows(out, image, row);
    return result;
}

}  // namespace cobble::renderer
