// SPDX-License-Identifier: MIT
// Pictures as file contents, and back.
#pragma once

#include <cstdint>
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
    bool encode_srgb = false;  ///< 8-bit formats only, with kRound
    std::string comment{};     ///< put into the file by add_comment() unless it is empty
};

/// What speaks against writing a picture of this size in any format, or "": known before there is
/// one.
std::string problem_of_size(std::uint64_t width, std::uint64_t height, std::uint32_t channels);

struct Encoded {
    std::string bytes;
    std::string error;  ///< empty if it worked
};

/// PNG, BMP and TGA clamp to 8 bits; PFM and EXR keep the numbers, bit for bit; HDR rounds them to
/// its 8-bit mantissas and takes what is negative or NaN for 0. A one-channel plane becomes grey.
/// NaN becomes 0 in 8-bit formats. One picture always gives the same bytes.
Encoded encode(const Plane32& plane, PictureFormat format, const EncodeOptions& options = {});

struct Decoded {
    Plane32 plane;  ///< three channels; 8-bit files as value / 255, 16-bit ones as value / 65535
    bool eight_bit = false;
    bool display = false;  ///< display values (PNG, BMP, TGA, JPEG), not light (PFM, HDR, EXR)
    std::string error;     ///< empty if it worked
};

/// Reads PNG, BMP, TGA, JPEG, PFM, HDR or EXR by content; grey becomes three equal channels, alpha
/// is dropped. At most 2^26 pixels. OpenEXR: one part of scan lines, uncompressed, run-length or
/// ZIP. Bytes that are none of these, or that break off, are errors, whatever they claim.
Decoded decode(std::string_view bytes);

}  // namespace cobble::renderer
