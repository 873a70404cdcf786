// SPDX-License-Identifier: MIT
#include "tools/cobble/option_values.hpp"

#include <fmt/core.h>

#include <vector>

#include "renderer/picture/picture_io.hpp"
#include "tools/driver/numbers.hpp"

namespace cobble {
namespace {

template <typename Number>
std::optional<std::vector<Number>> read(std::string_view text, char separator, std::size_t count) {
    std::vector<Number> numbers;
    if (!driver::parse_numbers(text, separator, count, numbers)) return std::nullopt;
    return numbers;
}

}  // namespace

std::optional<Size> parse_size(std::string_view text) {
    const auto fits = [](std::uint32_t side) { return side >= 1 && side <= renderer::kMaxSide; };
    const auto n = read<std::uint32_t>(text, 'x', 2);
    if (!n || !fits((*n)[0]) || !fits((*n)[1])) return std::nullopt;
    return Size{(*n)[0], (*n)[1]};
}

std::string to_text(const Size& size) { return fmt::format("{}x{}", size.width, size.height); }

std::optional<renderer::Crop> parse_crop(std::string_view text) {
    const auto n = read<std::uint32_t>(text, ',', 4);
    if (!n) return std::nullopt;
    const renderer::Crop crop{(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
    if (crop.x0 >= crop.x1 || crop.y0 >= crop.y1) return std::nullopt;
    return crop;
}

std::optional<DepthRange> parse_depth_range(std::string_view text) {
    const auto n = read<double>(text, ',', 2);
    if (!n || !((*n)[0] < (*n)[1])) return std::nullopt;
    return DepthRange{(*n)[0], (*n)[1]};
}

std::optional<Shard> parse_shard(std::string_view text) {
    const auto n = read<std::uint32_t>(text, '/', 2);
    if (!n || (*n)[0] < 1 || (*n)[0] > (*n)[1]) return std::nullopt;
    return Shard{(*n)[0], (*n)[1]};
}

std::optional<PixelPlace> parse_pixel(std::string_view text) {
    const auto n = read<std::uint32_t>(text, ',', 2);
    if (!n) return std::nullopt;
    return PixelPlace{(*n)[0], (*n)[1]};
}

std::optional<LineRange> parse_lines(std::string_view text) {
    const auto n = read<std::uint32_t>(text, ':', 2);
    if (!n || (*n)[0] < 1 || (*n)[0] > (*n)[1]) return std::nullopt;
    return LineRange{(*n)[0], (*n)[1]};
}

}  // namespace cobble
