// SPDX-License-Identifier: MIT
// Pictures as file contents, and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "renderer/film/picture.hpp"

namespace cobble::renderer {

enum class PictureFormat : unsigned char { kPng, kBmp, kTga, kPfm, kHdr, kExr };

/// By the ending of `path`, without regard to case; nothing if it names no format we write.
std::optional<PictureFormat> picture_format(std::string_view path);

enum class Quantise : unsigned char {
    kRound,     ///< floor(255 clamp(c) + 0.5)
    kTruncate,  ///< (int)(255 c), then clamped, as the published programs do
};

struct EncodeOptions {
    Quantise quantise = Quantise::kRound;
    bool encode_srgb = false;  ///< 8-bit formats only
};

struct Encoded {
    std::string bytes;
    std::string error;  ///< empty if it worked
};

/// PNG, BMP and TGA clamp to 8 bits; PFM, HDR and EXR keep the numbers (HDR to its 8-bit
/// mantissas). A one-channel plane becomes grey. NaN becomes 0 in 8-bit formats.
Encoded encode(const Plane32& plane, PictureFormat format, const EncodeOptions& options = {});

struct Decoded {
    Plane32 plane;  ///< three channels; 8-bit files as value / 255
    bool eight_bit = false;
    std::string error;  ///< empty if it worked
};

/// Reads PNG, BMP, TGA, JPEG, PFM, HDR or EXR by content.
Decoded decode(std::string_view bytes);

}  // namespace cobble::renderer
