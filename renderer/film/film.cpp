// SPDX-License-Identifier: MIT
#include "renderer/film/film.hpp"

#include <algorithm>
#include <limits>

namespace cobble::renderer {
namespace {

Plane32 make_plane(const Crop& window, std::uint32_t channels, float value) {
    Plane32 plane;
    plane.width = window.x1 - window.x0;
    plane.height = window.y1 - window.y0;
    plane.channels = channels;
    plane.values.assign(std::size_t{plane.width} * plane.height * channels, value);
    return plane;
}

float narrow(double value) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

void set3(Plane32& plane, std::size_t index, math::Vec3d value) {
    for (std::size_t i = 0; i < 3; ++i) plane.values[3 * index + i] = narrow(value[i]);
}

}  // namespace

Film::Film(const Settings& settings) : window_(window_of(settings)) {
    picture_.color = make_plane(window_, 3, 0.0F);
    if (settings.want_depth) {
        picture_.depth = make_plane(window_, 1, std::numeric_limits<float>::infinity());
    }
    if (settings.want_normals) picture_.normals = make_plane(window_, 3, 0.0F);
    if (settings.want_albedo) picture_.albedo = make_plane(window_, 3, 0.0F);
    if (settings.want_sample_count) picture_.sample_count = make_plane(window_, 1, 0.0F);
}

void Film::set_pixel(std::uint32_t x, std::uint32_t y, const Pixel& pixel) {
    set_color(x, y, pixel.color, pixel.samples);
    const std::size_t index = index_of(x, y);
    if (!picture_.depth.values.empty()) {
        picture_.depth.values[index] = pixel.depth == std::numeric_limits<double>::infinity()
                                           ? std::numeric_limits<float>::infinity()
                                           : narrow(pixel.depth);
    }
    if (!picture_.normals.values.empty()) set3(picture_.normals, index, pixel.normal);
    if (!picture_.albedo.values.empty()) set3(picture_.albedo, index, pixel.albedo);
}

void Film::set_color(std::uint32_t x, std::uint32_t y, math::Vec3d color, std::uint32_t samples) {
    const std::size_t index = index_of(x, y);
    set3(picture_.color, index, color);
    if (picture_.sample_count.values.empty()) return;
    picture_.sample_count.values[index] = static_cast<float>(samples);
}

}  // namespace cobble::renderer
