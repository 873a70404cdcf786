// SPDX-License-Identifier: MIT
#include "renderer/film/film.hpp"

#include <algorithm>
#include <limits>
#include <utility>

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
    begin_pass(0);
}

void Film::begin_pass(std::uint32_t scramble) {
    scramble_ = scramble;
    done_.assign(std::size_t{picture_.color.width} * picture_.color.height, 0);
}

void Film::restore(Picture picture, std::vector<std::uint8_t> done) {
    if (!sums_) picture_ = std::move(picture);
    done_ = std::move(done);
}

void Film::begin_sums(std::uint32_t scrambles, bool squares) {
    const std::size_t pixels = std::size_t{picture_.color.width} * picture_.color.height;
    sums_.emplace(
        pixels, scrambles,
        ScrambleSums::Wanted{!picture_.depth.values.empty(), !picture_.normals.values.empty(),
                             !picture_.albedo.values.empty(), squares});
}

void Film::show(std::size_t index, const Pixel& pixel, Picture& picture) const {
    set3(picture.color, index, pixel.color);
    if (!picture.sample_count.values.empty()) {
        picture.sample_count.values[index] = static_cast<float>(pixel.samples);
    }
    if (!picture.depth.values.empty()) {
        picture.depth.values[index] = pixel.depth == std::numeric_limits<double>::infinity()
                                          ? std::numeric_limits<float>::infinity()
                                          : narrow(pixel.depth);
    }
    if (!picture.normals.values.empty()) set3(picture.normals, index, pixel.normal);
    if (!picture.albedo.values.empty()) set3(picture.albedo, index, pixel.albedo);
}

void Film::set_pixel(std::uint32_t x, std::uint32_t y, const Pixel& pixel) {
    const std::size_t index = index_of(x, y);
    done_[index] = 1;
    if (sums_) return sums_->add(index, scramble_, pixel);
    show(index, pixel, picture_);
}

void Film::set_color(std::uint32_t x, std::uint32_t y, math::Vec3d color, std::uint32_t samples) {
    const std::size_t index = index_of(x, y);
    done_[index] = 1;
    if (sums_) return sums_->add_color(index, scramble_, color, samples);
    set3(picture_.color, index, color);
    if (picture_.sample_count.values.empty()) return;
    picture_.sample_count.values[index] = static_cast<float>(samples);
}

Picture Film::picture() const {
    Picture result = picture_;
    if (!sums_) return result;
    for (std::size_t i = 0; i < sums_->pixels(); ++i) show(i, sums_->pixel(i), result);
    return result;
}

}  // namespace cobble::renderer
