// SPDX-License-Identifier: MIT
// The formats behind picture_io.hpp, one pair of functions each. Private to this folder.
//
// Encoders take a plane that picture_io.cpp has checked (its values match its size, one or three
// channels, sides that the format can hold) or the bytes made of it; decoders take any bytes and
// believe no number in them before it is checked against the length of the file and against
// kMaxPixels.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/picture/picture_io.hpp"

namespace cobble::renderer {

/// The largest picture that is read: 8192 x 8192, 768 MiB as floats. A header that asks for more
/// is refused before any memory is taken.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 26;

/// Rows from the top, `channels` (1 or 3) bytes a pixel.
struct ByteImage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 3;
    std::string bytes;
};

Encoded encode_png(const ByteImage& image);
Encoded encode_bmp(const ByteImage& image);
Encoded encode_tga(const ByteImage& image);

/// Portable float map: rows from the bottom, little-endian 32-bit floats.
Encoded encode_pfm(const Plane32& plane);
Decoded decode_pfm(std::string_view bytes);

/// Radiance RGBE: three 8-bit mantissas that share an exponent. Written without run lengths.
Encoded encode_hdr(const Plane32& plane);
Decoded decode_hdr(std::string_view bytes);

/// OpenEXR, one part, scan lines. Written as 32-bit float, ZIP; read as half, float or 32-bit
/// integers, uncompressed or run-length, ZIPS and ZIP compressed.
Encoded encode_exr(const Plane32& plane);
Decoded decode_exr(std::string_view bytes);

/// PNG (8 and 16 bits), JPEG, BMP and TGA.
Decoded decode_bitmap(std::string_view bytes);

/// The reason why `bytes`, a BMP or TGA file by its first bytes, ends before its last pixel; empty
/// if it does not, or if it is something else.
std::string truncation_of(std::string_view bytes);

/// zlib streams, for OpenEXR. inflate gives nothing unless exactly `size` bytes come out.
std::string deflate(std::string_view bytes);
std::optional<std::string> inflate(std::string_view bytes, std::size_t size);

/// An error for a picture of these sides, or nothing. Zero sides are errors too.
std::string size_error(std::uint64_t width, std::uint64_t height);

/// A black picture of three channels.
Plane32 make_plane(std::uint32_t width, std::uint32_t height);

}  // namespace cobble::renderer
