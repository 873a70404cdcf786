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

/// Nothing past the end counts as zero: callers compare sizes afterwards.
std::uint32_t byte_at(std::string_view bytes, std::size_t offset) {
    return offset < bytes.size() ? static_cast<std::uint8_t>(bytes[offset]) : 0;
}

std::uint32_t get16(std::string_view bytes, std::size_t offset) {
    return byte_at(bytes, offset) | byte_at(bytes, offset + 1) << 8;
}

std::uint32_t get32(std::string_view bytes, std::size_t offset) {
    return get16(bytes, offset) | get16(bytes, offset + 2) << 16;
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

std::string truncation_of_bmp(std::string_view bytes) {
    constexpr const char* kShort = "the BMP file breaks off before its last pixel";
    constexpr std::size_t kHeaders = 26;  // up to the older header's last field
    if (bytes.size() < kHeaders) return kShort;
    const std::uint32_t header = get32(bytes, 14);
    const bool old = header == 12;
    const std::uint64_t width = old ? get16(bytes, 18) : get32(bytes, 18);
    const std::uint32_t signed_height = old ? get16(bytes, 20) : get32(bytes, 22);
    const std::uint64_t height =
        signed_height >= 0x80000000U ? 0x100000000U - signed_height : signed_height;
    const std::uint64_t bits = old ? get16(bytes, 24) : get16(bytes, 28);
    if (std::string error = size_error(width, height); !error.empty()) return error;
    const std::uint64_t row = (width * bits + 31) / 32 * 4;
    return get32(bytes, 10) + row * height > bytes.size() ? kShort : "";
}

/// TGA has no signature; this asks for what the decoder asks for.
bool looks_like_tga(std::string_view bytes) {
    if (byte_at(bytes, 1) > 1) return false;
    const std::uint32_t type = byte_at(bytes, 2) & ~8U;
    return type >= 1 && type <= 3 && byte_at(bytes, 2) < 12;
}

std::string truncation_of_tga(std::string_view bytes) {
    constexpr const char* kShort = "the TGA file breaks off before its last pixel";
    constexpr std::size_t kHeader = 18;
    if (bytes.size() < kHeader) return kShort;
    const std::uint64_t width = get16(bytes, 12);
    const std::uint64_t height = get16(bytes, 14);
    if (std::string error = size_error(width, height); !error.empty()) return error;
    const std::uint64_t pixel = (byte_at(bytes, 16) + 7) / 8;
    const std::uint64_t palette =
        byte_at(bytes, 1) == 1 ? get16(bytes, 5) * std::uint64_t{(byte_at(bytes, 7) + 7) / 8} : 0;
    std::uint64_t at = kHeader + byte_at(bytes, 0) + palette;
    const std::uint64_t pixels = width * height;
    if ((byte_at(bytes, 2) & 8) == 0) return at + pixels * pixel > bytes.size() ? kShort : "";
    // Run lengths: a packet is one byte (top bit: a run of one value), then one or n values.
    for (std::uint64_t done = 0; done < pixels;) {
        if (at >= bytes.size()) return kShort;
        const std::uint32_t packet = byte_at(bytes, static_cast<std::size_t>(at));
        const std::uint64_t count = (packet & 0x7f) + 1;
        at += 1 + ((packet & 0x80) != 0 ? pixel : count * pixel);
        done += count;
    }
    return at > bytes.size() ? kShort : "";
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

std::string truncation_of(std::string_view bytes) {
    if (bytes.starts_with("BM")) return truncation_of_bmp(bytes);
    const bool other = bytes.starts_with("\x89PNG") || bytes.starts_with("\xff\xd8");
    if (!other && looks_like_tga(bytes)) return truncation_of_tga(bytes);
    return {};
}

}  // namespace cobble::renderer
