// SPDX-License-Identifier: MIT
// The formats behind picture_io.hpp, one pair of functions each. Private to this folder.
//
// Encoders take a plane that picture_io.cpp has checked (its values match its size, one or three
// channels, sides that the format can hold) or the bytes made of it; decoders take any bytes and
// believe no number in them before it is checked against the length of the file and the limit.
// What textures are made of (PNG, JPEG, BMP, TGA, HDR) is read by ir/image.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "renderer/picture/picture_io.hpp"

namespace cobble::renderer {

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
Decoded decode_pfm(std::string_view bytes, std::uint64_t max_pixels);

/// Radiance RGBE: three 8-bit mantissas that share an exponent. Written without run lengths.
Encoded encode_hdr(const Plane32& plane);

/// OpenEXR, one part, scan lines. Written as 32-bit float, ZIP; read as half, float or 32-bit
/// integers, uncompressed or run-length, ZIPS and ZIP compressed.
Encoded encode_exr(const Plane32& plane);
Decoded decode_exr(std::string_view bytes, std::uint64_t max_pixels);

/// A zlib stream, for OpenEXR; empty if there is no memory for it.
std::string deflate(std::string_view bytes);

/// A black picture of three channels.
Plane32 make_plane(std::uint32_t width, std::uint32_t height);

}  // namespace cobble::renderer
