// SPDX-License-Identifier: MIT
// BMP and TGA: uncompressed, rows from the bottom, blue first, as the published programs wrote
// them.
#include <array>

#include "renderer/picture/codecs.hpp"

namespace cobble::renderer {
namespace {

void put16(std::string& out, std::uint32_t value) {
    out.push_back(static_cast<char>(value & 0xff));
    out.push_back(static_cast<char>(value >> 8 & 0xff));
}

void put32(std::string& out, std::uint32_t value) {
    put16(out, value & 0xffff);
    put16(out, value >> 16);
}

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
    put32(out, kHeaders + size);
    put32(out, 0);
    put32(out, kHeaders);
    put32(out, 40);
    put32(out, image.width);
    put32(out, image.height);
    put16(out, 1);   // planes
    put16(out, 24);  // bits a pixel
    put32(out, 0);   // uncompressed
    put32(out, size);
    for (int i = 0; i < 4; ++i) put32(out, 0);  // no resolution, no palette
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
    put16(out, image.width);
    put16(out, image.height);
    out.push_back(24);
    out.push_back(0);  // rows from the bottom
    put_rows(out, image, row);
    return result;
}

}  // namespace cobble::renderer
