// SPDX-License-Identifier: MIT
// Radiance pictures: Ward, "Real Pixels", Graphics Gems II, 1991, and the file format page of the
// Radiance manual. A pixel (r, g, b, e) is (r, g, b) * 2^(e - 136).
#include <fmt/format.h>

#include <array>
#include <bit>

#include "renderer/picture/codecs.hpp"

namespace cobble::renderer {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// 2^n as a double, -1022 <= n <= 1023: exact, and without the C library.
double exp2_int(int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52); }

/// Rounds to the nearest mantissas; the largest lies in [128, 255].
Rgbe rgbe_of(const std::array<float, 3>& color) {
    std::array<double, 3> value{};
    double largest = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        // NaN and what is negative become 0; the format ends below 2^127.
        const auto v = static_cast<double>(color[c]);
        value[c] = v > 0 ? (v < 0x1.fdp126 ? v : 0x1.fdp126) : 0;
        if (value[c] > largest) largest = value[c];
    }
    if (largest < 0x1p-127) return {};  // below the smallest exponent
    // The exponent field of a positive double: largest is in [2^(e-1), 2^e).
    int e = static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> 52) - 1022;
    if (largest * exp2_int(8 - e) + 0.5 >= 256) ++e;
    Rgbe result{};
    for (std::size_t c = 0; c < 3; ++c) {
        result[c] = static_cast<std::uint8_t>(value[c] * exp2_int(8 - e) + 0.5);
    }
    result[3] = static_cast<std::uint8_t>(e + 128);
    return result;
}

Decoded failed(std::string message) { return {{}, false, false, std::move(message)}; }

constexpr const char* kShort = "the HDR file breaks off before its last pixel";

std::string_view take_line(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

/// "-Y height +X width", the one orientation in use. False for anything else.
bool read_resolution(std::string_view line, std::uint64_t& width, std::uint64_t& height) {
    const auto take_number = [&line](std::string_view prefix, std::uint64_t& value) {
        if (!line.starts_with(prefix)) return false;
        line.remove_prefix(prefix.size());
        std::size_t digits = 0;
        for (value = 0; digits < line.size() && line[digits] >= '0' && line[digits] <= '9';) {
            if (digits == 9) return false;
            value = value * 10 + static_cast<std::uint64_t>(line[digits++] - '0');
        }
        line.remove_prefix(digits);
        return digits > 0;
    };
    return take_number("-Y ", height) && take_number(" +X ", width) && line.empty();
}

/// One component of a row in the newer run-length code. False if it breaks off or overflows.
bool read_runs(std::string_view& rest, std::vector<Rgbe>& row, std::size_t component) {
    for (std::size_t x = 0; x < row.size();) {
        if (rest.size() < 2) return false;
        const auto code = static_cast<std::uint8_t>(rest[0]);
        const bool run = code > 128;
        const std::size_t count = run ? code - 128U : code;
        if (count == 0 || count > row.size() - x || (!run && rest.size() < 1 + count)) return false;
        for (std::size_t i = 0; i < count; ++i) {
            row[x++][component] = static_cast<std::uint8_t>(rest[run ? 1 : 1 + i]);
        }
        rest.remove_prefix(run ? 2 : 1 + count);
    }
    return true;
}

/// A row of plain pixels, with the older code's repeats (1, 1, 1, count; further ones count in
/// units of 256).
bool read_flat(std::string_view& rest, std::vector<Rgbe>& row) {
    unsigned shift = 0;
    for (std::size_t x = 0; x < row.size();) {
        if (rest.size() < 4) return false;
        Rgbe pixel{};
        for (std::size_t c = 0; c < 4; ++c) pixel[c] = static_cast<std::uint8_t>(rest[c]);
        rest.remove_prefix(4);
        if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
            if (x == 0 || shift > 16) return false;
            const std::size_t count = std::size_t{pixel[3]} << shift;
            if (count > row.size() - x) return false;
            for (std::size_t i = 0; i < count; ++i, ++x) row[x] = row[x - 1];
            shift += 8;
        } else {
            row[x++] = pixel;
            shift = 0;
        }
    }
    return true;
}

bool read_row(std::string_view& rest, std::vector<Rgbe>& row) {
    const std::size_t width = row.size();
    const bool runs = width >= 8 && width < 32768 && rest.size() >= 4 && rest[0] == 2 &&
                      rest[1] == 2 && static_cast<std::uint8_t>(rest[2]) == width >> 8 &&
                      static_cast<std::uint8_t>(rest[3]) == (width & 0xff);
    if (!runs) return read_flat(rest, row);
    rest.remove_prefix(4);
    for (std::size_t c = 0; c < 4; ++c) {
        if (!read_runs(rest, row, c)) return false;
    }
    return true;
}

}  // namespace

Encoded encode_hdr(const Plane32& plane) {
    Encoded result;
    result.bytes = fmt::format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", plane.height,
                               plane.width);
    const std::size_t pixels = std::size_t{plane.width} * plane.height;
    result.bytes.reserve(result.bytes.size() + pixels * 4);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float* p = &plane.values[i * plane.channels];
        const bool grey = plane.channels == 1;
        // Rows without run lengths cannot be taken for others: the largest mantissa of a pixel that
        // is not black is at least 128, and both codes' marks have three or two small ones.
        for (const std::uint8_t byte : rgbe_of({p[0], p[grey ? 0 : 1], p[grey ? 0 : 2]})) {
            result.bytes.push_back(static_cast<char>(byte));
        }
    }
    return result;
}

Decoded decode_hdr(std::string_view bytes) {
    std::string_view rest = bytes;
    bool rgbe = false;
    for (std::string_view line = take_line(rest); !line.empty(); line = take_line(rest)) {
        if (line == "FORMAT=32-bit_rle_rgbe") rgbe = true;
        if (line == "FORMAT=32-bit_rle_xyze") return failed("HDR files in XYZ are not read");
    }
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    if (!rgbe || !read_resolution(take_line(rest), width, height)) {
        return failed("the HDR file's header is malformed");
    }
    if (std::string error = size_error(width, height); !error.empty()) return failed(error);
    // The shortest code of a row is two bytes for 127 values of one component of four.
    if (rest.size() < height * (width * 4 / 127 / 4)) return failed(kShort);
    Decoded result;
    result.plane =
        make_plane(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
    std::vector<Rgbe> row(width);
    float* out = result.plane.values.data();
    for (std::uint64_t y = 0; y < height; ++y) {
        if (!read_row(rest, row)) return failed(kShort);
        for (const Rgbe& pixel : row) {
            const double scale = pixel[3] == 0 ? 0 : exp2_int(int{pixel[3]} - 136);
            for (std::size_t c = 0; c < 3; ++c) *out++ = static_cast<float>(pixel[c] * scale);
        }
    }
    return result;
}

}  // namespace cobble::renderer
