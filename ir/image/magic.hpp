// SPDX-License-Identifier: MIT
// The bytes that files of some formats begin with.
#pragma once

#include <string_view>

namespace cobble::image {

/// PNG specification (W3C, 2003), section 5.2.
inline constexpr std::string_view kPngMagic("\x89PNG\r\n\x1a\n", 8);
/// OpenEXR file layout: 20000630, little-endian.
inline constexpr std::string_view kExrMagic("\x76\x2f\x31\x01", 4);

}  // namespace cobble::image
