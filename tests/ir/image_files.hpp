// SPDX-License-Identifier: MIT
// Small picture files, written byte by byte.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cobble::test {

/// A PNG with channels of `depth` bits. `type` 0 is grey, 2 RGB, 6 RGBA. `rows` holds each row
/// behind its filter byte; it is stored uncompressed.
std::string png(std::uint32_t width, std::uint32_t height, int type, std::string_view rows,
                int depth = 8);

/// The same around a zlib stream as given.
std::string png_of_stream(std::uint32_t width, std::uint32_t height, int type,
                          std::string_view zlib, int depth = 8);

/// A zlib stream that unpacks to about `size` zero bytes.
std::string deflate_zeros(std::size_t size);

/// A JPEG of one colour, 0xrrggbb.
std::string jpeg(int width, int height, std::uint32_t color);

/// {format, file}, all with the pixels 255 0 0, 0 255 0 / 0 0 255, 10 20 30.
std::vector<std::pair<std::string, std::string>> four_pixels();

}  // namespace cobble::test
