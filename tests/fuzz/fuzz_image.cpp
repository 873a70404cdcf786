// SPDX-License-Identifier: MIT
// Any bytes as a picture: what is decoded has the pixels it claims, within the limit.
#include <cstdint>
#include <string_view>

#include "ir/image/decoder.hpp"
#include "tests/fuzz/expect.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace cobble;
    using fuzz::expect;
    constexpr std::uint64_t kMaxPixels = 1 << 16;  // small, so that many inputs can be tried
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const bool sixteen_bits = size % 2 == 0;
    const image::Decoded decoded = image::decode(bytes, {kMaxPixels, sixteen_bits});
    const auto claimed = image::read_header(bytes);
    if (decoded.status != image::Status::kOk) {
        expect(!decoded.reason.empty(), "a failure has a reason");
        return 0;
    }
    const std::uint64_t pixels = std::uint64_t{decoded.width} * std::uint64_t{decoded.height};
    expect(pixels > 0 && pixels <= kMaxPixels, "the limit of pixels holds");
    expect(claimed && claimed->width == decoded.width && claimed->height == decoded.height &&
               claimed->floats == !decoded.floats.empty(),
           "the header says what is there");
    expect(decoded.bytes.size() + decoded.words.size() + decoded.floats.size() == 3 * pixels,
           "every pixel has three channels");
    expect(decoded.bytes.size() == 3 * pixels || decoded.words.size() == 3 * pixels ||
               decoded.floats.size() == 3 * pixels,
           "of one kind");
    return 0;
}
