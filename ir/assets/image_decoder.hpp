// SPDX-License-Identifier: MIT
// Bytes of a picture file to pixels. Input: BMP (8-bit palettes included), PNG, JPEG, TGA or
// Radiance HDR. Output: three channels, or a sentence saying what is wrong. Invariant: the size
// that the header claims is judged before memory is taken, and decoding never takes more than a
// fixed multiple of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ir/scene/assets.hpp"

namespace cobble::ir {

enum class DecodeStatus : std::uint8_t { kOk, kCorrupt, kTooLarge };

struct DecodedImage {
    DecodeStatus status = DecodeStatus::kCorrupt;
    std::string reason;  ///< for people, if it failed: "the file ends too early"
    Image image;         ///< width, height and either bytes or floats; tag kDisplay or kLinear
};

/// Grey becomes three equal channels; transparency is dropped; 16-bit channels keep their upper
/// byte. HDR files give floats, all others bytes.
DecodedImage decode_image(std::string_view bytes, std::uint64_t max_pixels);

/// The size that a header claims, without decoding; nothing if no reader knows the file.
std::optional<std::pair<std::uint32_t, std::uint32_t>> image_size(std::string_view bytes);

}  // namespace cobble::ir
