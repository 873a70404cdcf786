// SPDX-License-Identifier: MIT
#include "ir/image/integrity.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "ir/image/bytes.hpp"
#include "ir/image/crc32.hpp"
#include "ir/image/magic.hpp"
#include "ir/image/radiance.hpp"

namespace cobble::image {
namespace {

constexpr const char* kCutShort = "the file ends too early";

std::string png_damage(std::string_view bytes) {
    std::size_t at = kPngMagic.size();
    for (;;) {
        if (bytes.size() - at < 12) return kCutShort;
        const std::uint64_t length = big_endian(bytes, at, 4);
        if (length > bytes.size() - at - 12) return kCutShort;
        const auto chunk = bytes.substr(at + 4, static_cast<std::size_t>(length) + 4);
        const std::string_view name = chunk.substr(0, 4);
        at += static_cast<std::size_t>(length) + 8;
        if (crc32(chunk) != big_endian(bytes, at, 4)) {
            const bool printable =
                std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c < 0x7f; });
            return "the checksum of its " + (printable ? std::string(name) : "next") +
                   " chunk does not match";
        }
        at += 4;
        if (name == "IEND") return {};
    }
}

std::string bmp_damage(std::string_view bytes) {
    const std::uint64_t offset = little_endian(bytes, 10, 4);
    const std::uint64_t header = little_endian(bytes, 14, 4);
    const bool old = header == 12;
    const std::uint64_t width = old ? little_endian(bytes, 18, 2) : little_endian(bytes, 18, 4);
    const auto raw_height = old ? static_cast<std::int64_t>(little_endian(bytes, 20, 2))
                                : static_cast<std::int32_t>(little_endian(bytes, 22, 4));
    const auto height = static_cast<std::uint64_t>(std::abs(raw_height));
    const std::uint64_t bits = little_endian(bytes, old ? 24 : 28, 2);
    if (bytes.size() < 14 + header) return kCutShort;
    // Below 8 bits, pixels fill bytes: they do not straddle two.
    if (bits == 0 || bits > 32 || (bits < 8 && 8 % bits != 0)) {
        return "it claims " + std::to_string(bits) + " bits a pixel";
    }
    if (width == 0 || height == 0) return "it has no pixels";
    if (offset > bytes.size()) return kCutShort;
    // Divided, not multiplied: rows are below 2^35 bytes and heights at most 2^31. Some programs
    // leave out the padding of the last row.
    const std::uint64_t room = bytes.size() - offset;
    const std::uint64_t row = (width * bits + 31) / 32 * 4;
    const std::uint64_t packed = (width * bits + 7) / 8;
    if (packed > room || height - 1 > (room - packed) / row) return kCutShort;
    if (bits > 8) return {};
    const std::uint64_t entry = old ? 3 : 4;
    if (offset < 14 + header) return "its palette has no place";
    const std::uint64_t palette = (offset - 14 - header) / entry;
    if (palette >= (std::uint64_t{1} << bits)) return {};
    for (std::uint64_t y = 0; y < height; ++y) {
        for (std::uint64_t x = 0; x < width; ++x) {
            const std::uint64_t bit = x * bits;
            const std::uint64_t byte =
                byte_at(bytes, static_cast<std::size_t>(offset + y * row + bit / 8));
            const std::uint64_t index = (byte >> (8 - bits - bit % 8)) & ((1U << bits) - 1);
            if (index >= palette) return "a pixel is beyond its palette";
        }
    }
    return {};
}

std::string tga_damage(std::string_view bytes) {
    const std::uint64_t type = byte_at(bytes, 2);
    const bool indexed = byte_at(bytes, 1) != 0;
    const std::uint64_t palette = little_endian(bytes, 5, 2) * ((byte_at(bytes, 7) + 7) / 8);
    const std::uint64_t pixels = little_endian(bytes, 12, 2) * little_endian(bytes, 14, 2);
    const std::uint64_t unit = (byte_at(bytes, 16) + 7) / 8;
    std::uint64_t at = 18 + byte_at(bytes, 0) + (indexed ? palette : 0);
    if (type < 8) return at + pixels * unit > bytes.size() ? kCutShort : "";
    for (std::uint64_t done = 0; done < pixels;) {
        if (at >= bytes.size()) return kCutShort;
        const std::uint64_t command = byte_at(bytes, static_cast<std::size_t>(at));
        const std::uint64_t count = 1 + (command & 127);
        at += 1 + ((command & 128) != 0 ? unit : unit * count);
        done += count;
    }
    return at > bytes.size() ? kCutShort : "";
}

/// The decoder takes any number of 0xff before the first mark's code, and so must whoever guards
/// it.
bool is_jpeg(std::string_view bytes) {
    const std::size_t code = bytes.find_first_not_of('\xff');
    return code != 0 && code != std::string_view::npos && bytes[code] == '\xd8';
}

std::size_t segment_length(std::string_view bytes, std::size_t at) {
    return static_cast<std::size_t>(big_endian(bytes, at, 2));
}

/// True if one of the Huffman tables in a segment, whose length stands at `at`, claims more than
/// 256 symbols, for which stb_image 2.27 has no room: there are 16 lengths of codes, each with a
/// count of up to 255. A table is one byte, the 16 counts, and the symbols (ITU-T T.81, B.2.4.2).
bool has_oversized_table(std::string_view bytes, std::size_t at) {
    const std::size_t end = at + segment_length(bytes, at);
    for (at += 2; at < end && at < bytes.size();) {
        std::size_t symbols = 0;
        for (std::size_t i = 1; i <= 16; ++i) symbols += byte_at(bytes, at + i);
        if (symbols > 256) return true;
        at += 17 + symbols;
    }
    return false;
}

/// Walks from mark to mark, as the decoder does: what stands inside segments and compressed data is
/// not looked at, for it may look like anything.
std::string jpeg_damage(std::string_view bytes) {
    std::size_t at = bytes.find_first_not_of('\xff') + 1;  // behind the first mark's code
    bool in_scan = false;
    for (;;) {
        at = bytes.find('\xff', at);
        at = at == std::string_view::npos ? at : bytes.find_first_not_of('\xff', at);
        if (at == std::string_view::npos) return kCutShort;
        const std::uint64_t code = byte_at(bytes, at++);
        // A byte of data that is 0xff, or the start of a scan's next part.
        if (code == 0 || (code >= 0xd0 && code <= 0xd7)) continue;
        if (code == 0xd8) continue;
        if (code == 0xd9) return in_scan ? "" : kCutShort;
        if (code == 0xda) in_scan = true;
        if (code == 0xc4 && has_oversized_table(bytes, at)) {
            return "a Huffman table has more than 256 symbols";
        }
        at += std::max<std::size_t>(2, segment_length(bytes, at));
    }
}

}  // namespace

std::string_view image_format(std::string_view bytes) {
    if (bytes.starts_with(kPngMagic)) return "PNG";
    if (bytes.starts_with("BM")) return "BMP";
    if (is_jpeg(bytes)) return "JPEG";
    if (is_radiance(bytes)) return "HDR";
    return {};
}

std::string find_damage(std::string_view bytes) {
    const std::string_view format = image_format(bytes);
    if (format == "PNG") return png_damage(bytes);
    if (format == "BMP") return bmp_damage(bytes);
    if (format == "HDR") return read_radiance_header(bytes).problem;
    if (format == "JPEG") return jpeg_damage(bytes);
    return bytes.size() < 18 ? kCutShort : tga_damage(bytes);
}

}  // namespace cobble::image
