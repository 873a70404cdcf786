// SPDX-License-Identifier: MIT
#include "renderer/film/scramble_sums.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace cobble::renderer {

ScrambleSums::ScrambleSums(std::size_t pixels, std::uint32_t scrambles, Wanted wanted)
    : scrambles_(scrambles), color_(pixels * scrambles), samples_(pixels * scrambles) {
    if (wanted.depth || wanted.normals || wanted.albedo) hits_.resize(pixels);
    if (wanted.depth) depth_.resize(pixels);
    if (wanted.normals) normal_.resize(pixels);
    if (wanted.albedo) albedo_.resize(pixels);
    if (wanted.squares) squares_.resize(pixels);
}

void ScrambleSums::add_color(std::size_t pixel, std::uint32_t scramble, math::Vec3d mean,
                             std::uint32_t samples) {
    const std::size_t at = pixel * scrambles_ + scramble;
    if (!squares_.empty() && samples > 0) {
        for (std::size_t c = 0; c < 3; ++c) mean[c] = std::clamp(mean[c], 0.0, 1.0);
        squares_[pixel] += mean * mean;
    }
    color_[at] += mean * static_cast<double>(samples);
    samples_[at] += samples;
}

void ScrambleSums::add(std::size_t pixel, std::uint32_t scramble, const Pixel& seen) {
    add_color(pixel, scramble, seen.color, seen.samples);
    if (!normal_.empty()) normal_[pixel] += seen.normal * static_cast<double>(seen.samples);
    if (!albedo_.empty()) albedo_[pixel] += seen.albedo * static_cast<double>(seen.samples);
    if (hits_.empty() || seen.hits == 0) return;
    hits_[pixel] += seen.hits;
    if (!depth_.empty()) depth_[pixel] += seen.depth * static_cast<double>(seen.hits);
}

math::Vec3d ScrambleSums::mean_of(std::size_t pixel, std::uint32_t scramble) const {
    const std::size_t at = pixel * scrambles_ + scramble;
    if (samples_[at] == 0) return {};
    return color_[at] / static_cast<double>(samples_[at]);
}

math::Vec3d ScrambleSums::mean_square(std::size_t pixel) const {
    std::uint32_t samples = 0;
    for (std::uint32_t k = 0; k < scrambles_; ++k) samples += samples_of(pixel, k);
    if (samples == 0 || squares_.empty()) return {};
    return squares_[pixel] / static_cast<double>(samples);
}

Pixel ScrambleSums::pixel(std::size_t pixel) const {
    Pixel result;
    math::Vec3d color;
    for (std::size_t k = 0; k < scrambles_; ++k) {
        color += color_[pixel * scrambles_ + k];
        result.samples += samples_[pixel * scrambles_ + k];
    }
    if (result.samples == 0) return result;
    const double n = result.samples;
    result.color = color / n;
    if (!normal_.empty()) result.normal = normal_[pixel] / n;
    if (!albedo_.empty()) result.albedo = albedo_[pixel] / n;
    if (hits_.empty() || hits_[pixel] == 0) return result;
    result.hits = hits_[pixel];
    if (!depth_.empty()) result.depth = depth_[pixel] / static_cast<double>(result.hits);
    return result;
}

template <typename Visit>
void ScrambleSums::each_part(Visit&& visit, auto& self) {
    visit(self.color_);
    visit(self.samples_);
    visit(self.hits_);
    visit(self.depth_);
    visit(self.normal_);
    visit(self.albedo_);
    visit(self.squares_);
}

std::vector<std::uint8_t> ScrambleSums::bytes() const {
    std::vector<std::uint8_t> result;
    each_part(
        [&result](const auto& part) {
            static_assert(std::is_trivially_copyable_v<std::remove_cvref_t<decltype(part[0])>>);
            const auto* const begin = reinterpret_cast<const std::uint8_t*>(part.data());
            result.insert(result.end(), begin, begin + part.size() * sizeof(part[0]));
        },
        *this);
    return result;
}

bool ScrambleSums::restore(const std::vector<std::uint8_t>& bytes) {
    std::size_t expected = 0;
    each_part([&](const auto& part) { expected += part.size() * sizeof(part[0]); }, *this);
    if (bytes.size() != expected) return false;
    const std::uint8_t* from = bytes.data();
    each_part(
        [&](auto& part) {
            const std::size_t size = part.size() * sizeof(part[0]);
            if (size > 0) std::memcpy(part.data(), from, size);
            from += size;
        },
        *this);
    return true;
}

}  // namespace cobble::renderer
