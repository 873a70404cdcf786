// SPDX-License-Identifier: MIT
#include "tests/ir/image_files.hpp"

#include <algorithm>

#include "tests/ir/support.hpp"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace cobble::test {
namespace {

std::string big(std::uint32_t value) {
    std::string result = little(value, 4);
    std::reverse(result.begin(), result.end());
    return result;
}

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = 0xffffffffU;
    for (const char byte : bytes) {
        crc ^= static_cast<std::uint8_t>(byte);
        for (int k = 0; k < 8; ++k) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320U : 0);
    }
    return ~crc;
}

std::string chunk(std::string_view name, std::string_view data) {
    std::string body(name);
    body += data;
    return big(static_cast<std::uint32_t>(data.size())) + body + big(crc32(body));
}

std::uint32_t adler32(std::string_view bytes) {
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const char byte : bytes) {
        a = (a + static_cast<std::uint8_t>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

}  // namespace

std::string png_of_stream(std::uint32_t width, std::uint32_t height, int type,
                          std::string_view zlib, int depth) {
    std::string header = big(width) + big(height);
    header += static_cast<char>(depth);
    header += static_cast<char>(type);
    header.append(3, '\0');
    std::string file("\x89PNG\r\n\x1a\n", 8);
    file += chunk("IHDR", header);
    file += chunk("IDAT", zlib);
    file += chunk("IEND", "");
    return file;
}

std::string png(std::uint32_t width, std::uint32_t height, int type, std::string_view rows,
                int depth) {
    std::string zlib("\x78\x01\x01", 3);
    zlib += little(rows.size(), 2);
    zlib += little(~rows.size(), 2);
    zlib += rows;
    zlib += big(adler32(rows));
    return png_of_stream(width, height, type, zlib, depth);
}

std::string deflate_zeros(std::size_t size) {
    // A block with fixed codes: one literal 0, then pairs of length 258 (code 285, 8 bits
    // 11000101) and distance 1 (code 0, 5 bits). Bits are filled from the lowest.
    std::string zlib("\x78\x01", 2);
    unsigned bits = 0;
    int count = 0;
    const auto put = [&](unsigned value, int length) {
        for (int i = length - 1; i >= 0; --i) {
            bits |= (value >> i & 1) << count;
            if (++count == 8) {
                zlib += static_cast<char>(bits);
                bits = 0;
                count = 0;
            }
        }
    };
    put(1, 1);     // the last block
    put(2, 2);     // fixed codes: 01, lowest bit first
    put(0x30, 8);  // literal 0
    for (std::size_t done = 1; done < size; done += 258) {
        put(0xc5, 8);
        put(0, 5);
    }
    put(0, 7);
    put(0, 8);
    return zlib;
}

std::string jpeg(int width, int height, std::uint32_t color) {
    std::string pixels;
    for (int i = 0; i < width * height; ++i) {
        for (const int shift : {16, 8, 0}) pixels += static_cast<char>(color >> shift & 255);
    }
    std::string file;
    stbi_write_jpg_to_func(
        [](void* out, void* data, int size) {
            static_cast<std::string*>(out)->append(static_cast<char*>(data),
                                                   static_cast<std::size_t>(size));
        },
        &file, width, height, 3, pixels.data(), 95);
    return file;
}

std::vector<std::pair<std::string, std::string>> four_pixels() {
    const auto pixel = [](std::uint32_t x, std::uint32_t y) -> std::uint32_t {
        return y == 0 ? (x == 0 ? 0xff0000U : 0x00ff00U) : (x == 0 ? 0x0000ffU : 0x0a141eU);
    };
    std::vector<std::pair<std::string, std::string>> files;
    files.emplace_back("BMP", bmp(2, 2, pixel));
    files.emplace_back("PNG",
                       png(2, 2, 2, std::string("\0\xff\0\0\0\xff\0\0\0\0\xff\x0a\x14\x1e", 14)));
    std::string palette = bmp_header(2, 2, 8, 4);
    for (std::uint32_t i = 0; i < 4; ++i) palette += little(pixel(i % 2, i / 2), 4);
    palette += std::string("\x02\x03\0\0\0\x01\0\0", 8);
    files.emplace_back("BMP with a palette", palette);
    std::string header(2, '\0');
    header += '\x02';
    header.append(9, '\0');
    std::string tga = header + little(2, 2) + little(2, 2) + "\x18\x20";
    for (std::uint32_t i = 0; i < 4; ++i) tga += little(pixel(i % 2, i / 2), 3);
    files.emplace_back("TGA", tga);
    header[2] = '\x0a';
    std::string packed = header + little(2, 2) + little(2, 2) + "\x18\x20";
    packed += '\x03';
    for (std::uint32_t i = 0; i < 4; ++i) packed += little(pixel(i % 2, i / 2), 3);
    files.emplace_back("TGA in runs", packed);
    return files;
}

}  // namespace cobble::test
