// SPDX-License-Identifier: MIT
// Radiance HDR pictures: Ward, "Real Pixels", Graphics Gems II, 1991, and the file format page of
// the Radiance manual. A pixel (r, g, b, e) is (r, g, b) * 2^(e - 136), and 0 if e is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cobble::image {

/// True by the file's first bytes.
bool is_radiance(std::string_view bytes);

struct RadianceHeader {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::size_t size = 0;  ///< bytes of the header: the pixels follow
    std::string problem;   ///< for people; empty if it was read
};

/// Any header lines, with the pixels in RGB, rows from the top, columns from the left.
RadianceHeader read_radiance_header(std::string_view bytes);

/// Fills `pixels` with 3 width height numbers, unpacked or in either of the run-length codes. Gives
/// what is wrong with the file, or "". Takes no memory for a file too short for its size.
std::string decode_radiance(std::string_view bytes, const RadianceHeader& header,
                            std::vector<float>& pixels);

}  // namespace cobble::image
