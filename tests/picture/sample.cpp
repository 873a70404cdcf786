// SPDX-License-Identifier: MIT
#include "tests/picture/sample.hpp"

#include <tinyexr.h>

#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <limits>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace cobble::renderer {

Plane32 three_channels(const Plane32& plane) {
    Plane32 result{plane.width, plane.height, 3, {}};
    for (std::size_t i = 0; i < plane.values.size(); i += plane.channels) {
        for (std::size_t c = 0; c < 3; ++c) {
            result.values.push_back(plane.values[i + c % plane.channels]);
        }
    }
    return result;
}

Plane32 awkward_floats(std::uint32_t width, std::uint32_t height, std::uint32_t channels) {
    constexpr std::array<std::uint32_t, 8> kSpecial{0x00000000, 0x80000000, 0x7f800000, 0xff800000,
                                                    0x7fc12345, 0x00000001, 0x3f800000, 0x7f7fffff};
    Plane32 plane{width, height, channels, {}};
    Random random(7);
    for (std::size_t i = 0; i < std::size_t{width} * height * channels; ++i) {
        const std::uint32_t bits =
            i % 3 == 0 ? kSpecial[random.below(8)] : static_cast<std::uint32_t>(random.next());
        plane.values.push_back(std::bit_cast<float>(bits));
    }
    return plane;
}

Plane32 light(std::uint32_t width, std::uint32_t height) {
    Plane32 plane{width, height, 3, {}};
    Random random(8);
    for (std::size_t i = 0; i < std::size_t{width} * height * 3; ++i) {
        const float scale = static_cast<float>(1U << random.below(30)) * 0x1p-15F;
        plane.values.push_back((0.01F + random.unit()) * scale);
    }
    return plane;
}

Plane32 halves(std::uint32_t width, std::uint32_t height) {
    Plane32 plane{width, height, 3, {}};
    Random random(9);
    for (std::size_t i = 0; i < std::size_t{width} * height * 3; ++i) {
        // Runs of equal values, so that run lengths occur.
        if (i % 5 != 0 && random.below(2) == 0) {
            plane.values.push_back(plane.values.back());
            continue;
        }
        const auto mantissa = static_cast<float>(random.below(2048));
        const float sign = random.below(2) == 0 ? 1.0F : -1.0F;
        // 2^-24 is the smallest half; 2047 * 2^5 the largest.
        const float scale = static_cast<float>(1U << random.below(30)) * 0x1p-24F;
        plane.values.push_back(i % 97 == 0 ? sign * std::numeric_limits<float>::infinity()
                                           : sign * mantissa * scale);
    }
    return plane;
}

std::string written_by_tinyexr(const Plane32& plane, int compression, int pixel_type) {
    const std::size_t pixels = std::size_t{plane.width} * plane.height;
    std::array<std::vector<float>, 3> columns;  // B, G, R
    for (std::size_t i = 0; i < pixels * 3; ++i) columns[2 - i % 3].push_back(plane.values[i]);
    std::array<float*, 3> pointers{columns[0].data(), columns[1].data(), columns[2].data()};

    EXRImage image;
    InitEXRImage(&image);
    image.num_channels = 3;
    image.images = reinterpret_cast<unsigned char**>(pointers.data());
    image.width = static_cast<int>(plane.width);
    image.height = static_cast<int>(plane.height);

    EXRHeader header;
    InitEXRHeader(&header);
    header.num_channels = 3;
    header.compression_type = compression;
    std::array<EXRChannelInfo, 3> channels{};
    std::array<int, 3> given{};
    std::array<int, 3> asked{};
    for (std::size_t c = 0; c < 3; ++c) {
        channels[c].name[0] = "BGR"[c];
        given[c] = TINYEXR_PIXELTYPE_FLOAT;
        asked[c] = pixel_type;
    }
    header.channels = channels.data();
    header.pixel_types = given.data();
    header.requested_pixel_types = asked.data();

    unsigned char* memory = nullptr;
    const char* message = nullptr;
    const std::size_t size = SaveEXRImageToMemory(&image, &header, &memory, &message);
    std::string bytes(reinterpret_cast<const char*>(memory), size);
    std::free(memory);
    return bytes;
}

std::string written_as_jpeg(const Plane32& plane) {
    std::string pixels;
    for (const float value : plane.values) {
        pixels.push_back(static_cast<char>(static_cast<int>(value * 255.0F)));
    }
    std::string bytes;
    const auto append = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                                   static_cast<std::size_t>(size));
    };
    stbi_write_jpg_to_func(append, &bytes, static_cast<int>(plane.width),
                           static_cast<int>(plane.height), 3, pixels.data(), 95);
    return bytes;
}

}  // namespace cobble::renderer
