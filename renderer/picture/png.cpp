// SPDX-License-Identifier: MIT
// PNG files and zlib streams by stb_image_write, whose code is private to this file: a program that
// links this library may have its own.
#include <cstdlib>
#include <memory>

#include "renderer/picture/codecs.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
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

/// The library counts in int.
constexpr std::size_t kMaxBytes = 0x7fffffff;

void append(void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
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

}  // namespace cobble::renderer
