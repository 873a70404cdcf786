// SPDX-License-Identifier: MIT
// Any bytes as a texture: what is decoded has the pixels it claims, within the limit.
#include <cstdint>
#include <string_view>

#include "ir/assets/image_decoder.hpp"
#include "tests/fuzz/expect.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cobble;
    using fuzz::expect;
    constexpr std::uint64_t kMaxPixels = 1 << 16;  // small, so that many inputs can be tried
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const ir::DecodedImage decoded = ir::decode_image(bytes, kMaxPixels);
    const auto claimed = ir::image_size(bytes);
    if (decoded.status != ir::DecodeStatus::kOk) {
        expect(!decoded.reason.empty(), "a failure has a reason");
        return 0;
    }
    const std::uint64_t pixels =
        std::uint64_t{decoded.image.width} * std::uint64_t{decoded.image.height};
    expect(pixels > 0 && pixels <= kMaxPixels, "the limit of pixels holds");
    expect(
        claimed && claimed->first == decoded.image.width && claimed->second == decoded.image.height,
        "the header says what is there");
    expect(decoded.image.bytes.size() + decoded.image.floats.size() == 3 * pixels,
           "every pixel has three channels");
    expect(decoded.image.bytes.empty() || decoded.image.floats.empty(), "of one kind");
    return 0;
}
