// SPDX-License-Identifier: MIT
#include "renderer/shading/texture.hpp"

#include <algorithm>
#include <cmath>

namespace cobble::renderer {
namespace {

/// Raw numbers of a texel: bytes as they are, floats scaled alike.
math::Vec3d raw_texel(const ir::Image& image, std::uint32_t x, std::uint32_t y) {
    const std::size_t at = 3 * (std::size_t{y} * image.width + x);
    if (!image.bytes.empty()) {
        return {static_cast<double>(image.bytes[at]), static_cast<double>(image.bytes[at + 1]),
                static_cast<double>(image.bytes[at + 2])};
    }
    return math::Vec3d{image.floats[at], image.floats[at + 1], image.floats[at + 2]} * 255.0;
}

/// The two texels on either side of a coordinate in [0, 1), and how far it is toward the second.
struct Neighbours {
    std::uint32_t first = 0, second = 0;
    double fraction = 0;
};

Neighbours neighbours(double coordinate, std::uint32_t size) {
    const double at = coordinate * size - 0.5;
    const double floor = std::floor(at);  // -1 to size - 1
    const auto first = static_cast<std::int64_t>(floor);
    const std::int64_t last = std::int64_t{size} - 1;
    return {static_cast<std::uint32_t>(first < 0 ? last : first),
            static_cast<std::uint32_t>(first >= last ? 0 : first + 1), at - floor};
}

std::uint32_t nearest(double coordinate, std::uint32_t size) {
    return std::min(static_cast<std::uint32_t>(coordinate * size), size - 1);
}

template <typename Texel>
math::Vec3d filtered(const ir::Image& image, ir::TextureFilter filter, math::Vec2d uv,
                     const Texel& texel_at) {
    const double u = wrap_unit(uv.x);
    const double v = wrap_unit(uv.y);
    if (filter == ir::TextureFilter::kNearest) {
        return texel_at(nearest(u, image.width), image.height - 1 - nearest(v, image.height));
    }
    const Neighbours x = neighbours(u, image.width);
    const Neighbours y = neighbours(v, image.height);
    const std::uint32_t top = image.height - 1;
    const math::Vec3d low =
        math::lerp(texel_at(x.first, top - y.first), texel_at(x.second, top - y.first), x.fraction);
    const math::Vec3d high = math::lerp(texel_at(x.first, top - y.second),
                                        texel_at(x.second, top - y.second), x.fraction);
    return math::lerp(low, high, y.fraction);
}

bool has_texels(const ir::Image& image) {
    return !image.missing && image.width > 0 && image.height > 0;
}

}  // namespace

ir::Color texel(const ir::Image& image, std::uint32_t x, std::uint32_t y) {
    if (!image.bytes.empty()) return raw_texel(image, x, y) / 255.0;
    const std::size_t at = 3 * (std::size_t{y} * image.width + x);
    return {image.floats[at], image.floats[at + 1], image.floats[at + 2]};
}

double wrap_unit(double x) {
    constexpr double kBelowOne = 0x1.fffffffffffffp-1;
    const double fraction = x - std::floor(x);
    return fraction >= 1 ? kBelowOne : fraction;
}

ir::Color error_checker(math::Vec2d uv) {
    const double column = std::floor(wrap_unit(uv.x) * 8);
    const double row = std::floor(wrap_unit(uv.y) * 8);
    const bool odd = (static_cast<int>(column + row) & 1) != 0;
    return odd ? ir::Color{} : kErrorColor;
}

ir::Color sample_texture(const ir::Image& image, ir::TextureFilter filter, math::Vec2d uv) {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return kErrorColor;
    if (!has_texels(image)) return error_checker(uv);
    return filtered(image, filter, uv,
                    [&](std::uint32_t x, std::uint32_t y) { return texel(image, x, y); });
}

math::Vec3d sample_data(const ir::Image& image, ir::TextureFilter filter, math::Vec2d uv) {
    if (!has_texels(image)) return {128, 128, 255};
    return filtered(image, filter, uv,
                    [&](std::uint32_t x, std::uint32_t y) { return raw_texel(image, x, y); });
}

}  // namespace cobble::renderer
