// SPDX-License-Identifier: MIT
// Portable float maps: "PF" or "Pf" (grey), width, height and a scale whose sign tells the byte
// order (negative: little-endian), each separated by white space; one white space; rows from the
// bottom.
#include <fmt/format.h>

#include <bit>

#include "ir/image/bytes.hpp"
#include "ir/image/decoder.hpp"
#include "renderer/picture/codecs.hpp"

namespace cobble::renderer {
namespace {

void put_float(std::string& out, float value) {
    image::put_little_endian(out, std::bit_cast<std::uint32_t>(value), 4);
}

float get_float(std::string_view bytes, std::size_t offset, bool little) {
    const std::uint64_t bits =
        little ? image::little_endian(bytes, offset, 4) : image::big_endian(bytes, offset, 4);
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
}

constexpr bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// The next word and, after it, the one white space that ends it. Empty at the end of the bytes.
std::string_view take_word(std::string_view& rest) {
    while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
    std::size_t end = 0;
    while (end < rest.size() && !is_space(rest[end])) ++end;
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(end == rest.size() ? end : end + 1);
    return word;
}

/// 0 for anything but a short run of digits: no picture has no pixels.
std::uint64_t number(std::string_view word) {
    if (word.empty() || word.size() > 9) return 0;
    std::uint64_t value = 0;
    for (const char c : word) {
        if (c < '0' || c > '9') return 0;
        value = value * 10 + static_cast<std::uint64_t>(c - '0');
    }
    return value;
}

Decoded failed(std::string message) { return {{}, false, false, std::move(message)}; }

}  // namespace

Encoded encode_pfm(const Plane32& plane) {
    Encoded result;
    result.bytes = fmt::format("{}\n{} {}\n-1.0\n", plane.channels == 3 ? "PF" : "Pf", plane.width,
                               plane.height);
    const std::size_t row = std::size_t{plane.width} * plane.channels;
    result.bytes.reserve(result.bytes.size() + row * plane.height * 4);
    for (std::uint32_t y = plane.height; y-- > 0;) {
        for (std::size_t i = 0; i < row; ++i) put_float(result.bytes, plane.values[y * row + i]);
    }
    return result;
}

Decoded decode_pfm(std::string_view bytes, std::uint64_t max_pixels) {
    std::string_view rest = bytes;
    const std::string_view kind = take_word(rest);
    if (kind != "PF" && kind != "Pf") return failed("the PFM file's header is malformed");
    const std::uint64_t width = number(take_word(rest));
    const std::uint64_t height = number(take_word(rest));
    const std::string_view scale = take_word(rest);
    if (scale.empty() || scale.find_first_not_of("+-.0123456789eE") != std::string_view::npos) {
        return failed("the PFM file's header is malformed");
    }
    // Its sign tells the byte order, which 0 has none for.
    const std::string_view digits = scale.substr(0, scale.find_first_of("eE"));
    if (digits.find_first_of("123456789") == std::string_view::npos) {
        return failed("the PFM file's scale is 0");
    }
    if (std::string error = image::size_problem(width, height, max_pixels); !error.empty()) {
        return failed(std::move(error));
    }
    const std::size_t channels = kind == "PF" ? 3 : 1;
    if (rest.size() / (4 * channels) < width * height) {
        return failed("the PFM file breaks off before its last pixel");
    }
    const bool little = scale.front() == '-';
    Decoded result;
    result.plane =
        make_plane(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
    for (std::size_t y = 0; y < height; ++y) {
        float* row = &result.plane.values[(height - 1 - y) * width * 3];
        for (std::size_t x = 0; x < width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                const std::size_t at = ((y * width + x) * channels + c % channels) * 4;
                row[x * 3 + c] = get_float(rest, at, little);
            }
        }
    }
    return result;
}

}  // namespace cobble::renderer
