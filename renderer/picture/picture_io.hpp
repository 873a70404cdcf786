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

/// The largest picture that is written or read: the library behind PNG counts bytes in 32 bits with
/// a sign, and a pixel takes up to three floats. One limit for all formats, so that what a render
/// wrote can always be compared, merged and converted.
inline constexpr std::uint64_t kMaxPixels = 0x7fffffffU / 12;

/// The largest side that every format can name: TGA has 16 bits for it.
inline constexpr std::uint32_t kMaxSide = 65535;

/// What speaks against writing a picture of this size in any format, or "": known before there is
/// one.
std::string problem_of_size(std::uint64_t width, std::uint64_t height);

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
/// is dropped. OpenEXR: one part of scan lines, uncompressed, run-length or ZIP. Bytes that are
/// none of these, that break off or whose checksums are wrong are errors, whatever they claim.
Decoded decode(std::string_view bytes, std::uint64_t max_pixels = kMaxPixels);

}  // namespace cobble::renderer
