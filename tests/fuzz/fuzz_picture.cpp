// SPDX-License-Identifier: MIT
// Any bytes as a picture to compare, and what was read written and read again.
#include <cstdint>
#include <string_view>

#include "renderer/picture/picture_io.hpp"
#include "tests/fuzz/expect.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cobble;
    using fuzz::expect;
    constexpr std::uint64_t kMaxPixels = 1 << 20;  // small, so that many inputs can be tried
    const renderer::Decoded decoded =
        renderer::decode({reinterpret_cast<const char*>(data), size}, kMaxPixels);
    if (!decoded.error.empty()) return 0;
    const std::uint64_t pixels =
        std::uint64_t{decoded.plane.width} * std::uint64_t{decoded.plane.height};
    expect(pixels > 0, "a picture has pixels");
    expect(decoded.plane.values.size() == pixels * decoded.plane.channels,
           "every pixel has its channels");
    expect(pixels <= kMaxPixels, "the limit of pixels holds");
    constexpr std::uint64_t kMaxWritten = 1 << 14;  // writing larger ones takes too long
    if (pixels > kMaxWritten) return 0;
    for (const auto format : {renderer::PictureFormat::kPng, renderer::PictureFormat::kBmp,
                              renderer::PictureFormat::kTga, renderer::PictureFormat::kPfm,
                              renderer::PictureFormat::kHdr, renderer::PictureFormat::kExr}) {
        const renderer::Encoded encoded = renderer::encode(decoded.plane, format);
        expect(encoded.error.empty(), "what was read can be written");
        const renderer::Decoded again = renderer::decode(encoded.bytes);
        expect(again.error.empty(), "what was written can be read");
        expect(
            again.plane.width == decoded.plane.width && again.plane.height == decoded.plane.height,
            "it has the same size");
    }
    return 0;
}
