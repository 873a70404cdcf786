// SPDX-License-Identifier: MIT
// Pictures to write and read.
#pragma once

#include <cstdint>
#include <string>

#include "renderer/film/picture.hpp"

namespace cobble::renderer {

/// A small generator (xorshift, Marsaglia 2003), so that every run sees the same numbers.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15U + 1) {}
    std::uint64_t next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return state_;
    }
    std::uint64_t below(std::uint64_t bound) { return (next() >> 16) % bound; }
    float unit() { return static_cast<float>(next() >> 40) * 0x1p-24F; }

  private:
    std::uint64_t state_;
};

/// Grey repeated three times; three channels as they are.
Plane32 three_channels(const Plane32& plane);
/// Zeros of both signs, infinities, NaN with a payload, denormals, and random bits.
Plane32 awkward_floats(std::uint32_t width, std::uint32_t height, std::uint32_t channels);
/// Positive numbers over thirty powers of two.
Plane32 light(std::uint32_t width, std::uint32_t height);
/// Numbers that half precision holds exactly, its denormals and infinity among them.
Plane32 halves(std::uint32_t width, std::uint32_t height);
/// The plane (three channels) as an EXR file by the tinyexr library.
std::string written_by_tinyexr(const Plane32& plane, int compression, int pixel_type);
/// The plane (three channels, values from 0 to 1) as a JPEG file of high quality.
std::string written_as_jpeg(const Plane32& plane);

}  // namespace cobble::renderer
