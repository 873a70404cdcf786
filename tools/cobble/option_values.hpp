// SPDX-License-Identifier: MIT
// What the values of options mean that are more than a number or a word. Each is read here and
// nowhere else; nothing is what is written wrongly.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/settings.hpp"

namespace cobble {

struct Size {
    std::uint32_t width = 640, height = 480;
};
/// "WxH", both from 1 to renderer::kMaxSide.
std::optional<Size> parse_size(std::string_view text);
std::string to_text(const Size& size);

/// "X0,Y0,X1,Y1" with X0 < X1 and Y0 < Y1.
std::optional<renderer::Crop> parse_crop(std::string_view text);

struct DepthRange {
    double min = 0, max = 1;
};
/// "MIN,MAX" with MIN < MAX.
std::optional<DepthRange> parse_depth_range(std::string_view text);

struct Shard {
    std::uint32_t index = 1, count = 1;  ///< from 1
};
/// "I/N" with 1 <= I <= N.
std::optional<Shard> parse_shard(std::string_view text);

struct PixelPlace {
    std::uint32_t x = 0, y = 0;
};
/// "X,Y".
std::optional<PixelPlace> parse_pixel(std::string_view text);

struct LineRange {
    std::uint32_t first = 1, last = 1;
};
/// "L1:L2" with 1 <= L1 <= L2.
std::optional<LineRange> parse_lines(std::string_view text);

}  // namespace cobble
