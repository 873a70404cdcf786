// SPDX-License-Identifier: MIT
// A comment comes back from every format, and changes nothing else.
#include "renderer/picture/comment.hpp"

#include <doctest/doctest.h>
#include <tinyexr.h>

#include <cstdlib>

#include "tests/picture/sample.hpp"

namespace cobble::renderer {
namespace {

constexpr PictureFormat kFormats[] = {PictureFormat::kPng, PictureFormat::kBmp,
                                      PictureFormat::kTga, PictureFormat::kPfm,
                                      PictureFormat::kHdr, PictureFormat::kExr};

Encoded encoded(const Plane32& plane, PictureFormat format, const std::string& comment) {
    EncodeOptions options;
    options.comment = comment;
    return encode(plane, format, options);
}

TEST_CASE("a comment comes back, of any length, and the pixels are as without it") {
    for (const PictureFormat format : kFormats) {
        for (const std::size_t length : {std::size_t{1}, std::size_t{80}, kMaxComment}) {
            for (const std::uint32_t height : {1U, 16U, 50U}) {
                CAPTURE(static_cast<int>(format));
                CAPTURE(length);
                const Plane32 plane = light(21, height);
                const std::string comment = std::string(length - 1, 'x') + '.';
                const Encoded with = encoded(plane, format, comment);
                REQUIRE(with.error == "");
                CHECK(comment_of(with.bytes) == comment);
                const Encoded without = encode(plane, format);
                CHECK(comment_of(without.bytes) != comment);
                CHECK(with.bytes.size() > without.bytes.size());
                const Decoded a = decode(with.bytes);
                const Decoded b = decode(without.bytes);
                REQUIRE(a.error == "");
                CHECK(a.plane.width == b.plane.width);
                CHECK(a.plane.height == b.plane.height);
                CHECK(a.plane.values == b.plane.values);
            }
        }
    }
}

TEST_CASE("another reader takes an EXR file with a comment") {
    const Plane32 plane = light(21, 50);
    const std::string bytes = encoded(plane, PictureFormat::kExr, "hello").bytes;
    float* pixels = nullptr;
    int width = 0;
    int height = 0;
    const char* error = nullptr;
    REQUIRE(LoadEXRFromMemory(&pixels, &width, &height,
                              reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                              &error) == TINYEXR_SUCCESS);
    REQUIRE(width == 21);
    REQUIRE(height == 50);
    for (std::size_t i = 0; i < std::size_t{21} * 50; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            REQUIRE(pixels[i * 4 + c] == plane.values[i * 3 + c]);
        }
    }
    std::free(pixels);
}

TEST_CASE("a file without a comment, or cut anywhere, has none and does no harm") {
    CHECK(comment_of("") == "");
    for (const PictureFormat format : kFormats) {
        const std::string bytes = encoded(light(5, 3), format, "hello").bytes;
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            const std::string comment = comment_of(std::string_view(bytes).substr(0, size));
            CHECK(comment.size() <= kMaxComment);
        }
    }
    // Lengths that lie.
    CHECK(comment_of(std::string("\x89PNG\r\n\x1a\n\xff\xff\xff\xfftEXtComment\0hello", 29)) == "");
    CHECK(comment_of(std::string("\x76\x2f\x31\x01\x02\0\0\0comments\0string\0\xff\xff\xff\xffx",
                                 29)) == "");
}

}  // namespace
}  // namespace cobble::renderer
