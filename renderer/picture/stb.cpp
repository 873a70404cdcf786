// SPDX-License-Identifier: MIT
// PNG, JPEG, BMP, TGA and zlib by the stb libraries, private to this file: others may have their
// own copy.
#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "renderer/picture/codecs.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_NO_SIMD  // so that a JPEG has the same values everywhere
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace cobble::renderer {
namespace {

struct Free {
    void operator()(void* memory) const { std::free(memory); }
};
template <typename T>
using Owned = std::unique_ptr<T[], Free>;

const stbi_uc* data_of(std::string_view bytes) {
    return reinterpret_cast<const stbi_uc*>(bytes.data());
}

/// The library counts in int.
constexpr std::size_t kMaxBytes = 0x7fffffff;

Decoded failed(std::string message) { return {{}, false, false, std::move(message)}; }

void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
}

/// The library writes past its tables when a JPEG file's Huffman table claims more than 256 symbols
/// (each of 16 code lengths has its own count, up to 255). Looks at every mark of such tables (0xff
/// 0xc4; compressed data cannot contain it), two bytes of length, then tables: one byte, the 16
/// counts, the symbols. Any number of 0xff may stand before the code of the first mark.
bool has_oversized_table(std::string_view bytes) {
    const std::size_t code = bytes.find_first_not_of('\xff');
    if (code == 0 || code == std::string_view::npos || bytes[code] != '\xd8') return false;
    const auto byte = [bytes](std::size_t at) {
        return at < bytes.size() ? static_cast<std::uint8_t>(bytes[at]) : std::uint8_t{0};
    };
    for (std::size_t mark = bytes.find("\xff\xc4"); mark != std::string_view::npos;
         mark = bytes.find("\xff\xc4", mark + 1)) {
        const std::size_t end = mark + 2 + std::size_t{byte(mark + 2)} * 256 + byte(mark + 3);
        for (std::size_t at = mark + 4; at < end && at < bytes.size();) {
            std::size_t symbols = 0;
            for (std::size_t i = 1; i <= 16; ++i) symbols += byte(at + i);
            if (symbols > 256) return true;
            at += 17 + symbols;
        }
    }
    return false;
}

template <typename T>
void copy_scaled(Plane32& plane, const T* from, float largest) {
    for (float& value : plane.values) value = static_cast<float>(*from++) / largest;
}

}  // namespace

Encoded encode_png(const ByteImage& image) {
    Encoded result;
    const int channels = static_cast<int>(image.channels);
    const int width = static_cast<int>(image.width);
    if (stbi_write_png_to_func(append, &result.bytes, width, static_cast<int>(image.height),
                               channels, image.bytes.data(), width * channels) == 0) {
        return {{}, "not enough memory to write a PNG file"};
    }
    return result;
}

Decoded decode_bitmap(std::string_view bytes) {
    if (bytes.size() > kMaxBytes) return failed("the picture file is larger than 2 GiB");
    if (has_oversized_table(bytes)) return failed("the picture file is corrupt (Huffman table)");
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data_of(bytes), size, &width, &height, &channels) == 0 || width < 0) {
        return failed("not a PNG, BMP, TGA, JPEG, PFM, HDR or EXR picture");
    }
    const auto w = static_cast<std::uint32_t>(width);
    // BMP stores pictures that run downwards with a negative height.
    const auto h =
        height < 0 ? 0U - static_cast<std::uint32_t>(height) : static_cast<std::uint32_t>(height);
    if (std::string error = size_error(w, h); !error.empty()) return failed(error);
    Decoded result;
    result.display = true;
    if (stbi_is_16_bit_from_memory(data_of(bytes), size) != 0) {
        const Owned<stbi_us> pixels(
            stbi_load_16_from_memory(data_of(bytes), size, &width, &height, &channels, 3));
        if (pixels) {
            result.plane = make_plane(w, h);
            copy_scaled(result.plane, pixels.get(), 65535.0F);
            return result;
        }
    } else {
        const Owned<stbi_uc> pixels(
            stbi_load_from_memory(data_of(bytes), size, &width, &height, &channels, 3));
        if (pixels) {
            result.eight_bit = true;
            result.plane = make_plane(w, h);
            copy_scaled(result.plane, pixels.get(), 255.0F);
            return result;
        }
    }
    return failed(fmt::format("the picture file is corrupt ({})", stbi_failure_reason()));
}

std::string deflate(std::string_view bytes) {
    if (bytes.size() > kMaxBytes / 2) return {};
    constexpr int kQuality = 8;  // the library's own choice for PNG
    std::string copy(bytes);     // the library asks for writable memory
    int size = 0;
    const Owned<unsigned char> packed(
        stbi_zlib_compress(reinterpret_cast<unsigned char*>(copy.data()),
                           static_cast<int>(copy.size()), &size, kQuality));
    if (!packed) return {};
    return {reinterpret_cast<const char*>(packed.get()), static_cast<std::size_t>(size)};
}

std::optional<std::string> inflate(std::string_view bytes, std::size_t size) {
    if (bytes.size() > kMaxBytes || size > kMaxBytes) return std::nullopt;
    std::string out(size, '\0');
    const int written = stbi_zlib_decode_buffer(out.data(), static_cast<int>(size), bytes.data(),
                                                static_cast<int>(bytes.size()));
    if (written < 0 || static_cast<std::size_t>(written) != size) return std::nullopt;
    return out;
}

}  // namespace cobble::renderer
