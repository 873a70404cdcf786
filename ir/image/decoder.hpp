// SPDX-License-Identifier: MIT
// Bytes of a picture file to pixels. Input: BMP (8-bit palettes included), PNG, JPEG, TGA or
// Radiance HDR, told apart by content. Output: three channels, or a sentence saying what is wrong.
// Invariant: the size that the header claims is judged before memory is taken, and decoding never
// takes more than a fixed multiple of it. Textures and pictures to compare are both read here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cobble::image {

enum class Status : std::uint8_t {
    kOk,
    kUnknown,  ///< none of the formats above
    kCorrupt,
    kTooLarge,
};

struct Options {
    std::uint64_t max_pixels = 0;  ///< width times height
    bool sixteen_bits = false;     ///< keep them; else the upper byte of each
};

/// Rows from the top, three channels interleaved. One of the arrays is filled, with 3 width height
/// entries: `floats` (light) by HDR files, `words` by those of 16 bits if asked for, else `bytes`.
struct Decoded {
    Status status = Status::kUnknown;
    std::string reason;  ///< for people, if it failed: "the file ends too early"
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint16_t> words;
    std::vector<float> floats;
};

/// Grey becomes three equal channels; transparency is dropped.
Decoded decode(std::string_view bytes, const Options& options);

struct Header {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    bool floats = false;  ///< an HDR file
};

/// What a header claims, without decoding; nothing if no reader knows the file.
std::optional<Header> read_header(std::string_view bytes);

/// What speaks against a picture of these sides, for people, or "".
std::string size_problem(std::uint64_t width, std::uint64_t height, std::uint64_t max_pixels);

/// Unpacks a zlib stream (RFC 1950); nothing unless exactly `size` bytes come out.
std::optional<std::string> inflate(std::string_view bytes, std::size_t size);

}  // namespace cobble::image
