// SPDX-License-Identifier: MIT
#include "ir/image/radiance.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "ir/image/bytes.hpp"
#include "ir/math/power_of_two.hpp"

namespace cobble::image {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

constexpr const char* kCutShort = "the file ends too early";

/// The next line without its end; nothing if it does not end.
std::optional<std::string_view> take_line(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

/// A prefix, blanks and up to nine digits at the front of `line`, which they leave. Nothing if
/// something else stands there.
std::optional<std::uint32_t> take_side(std::string_view& line, std::string_view prefix) {
    if (!line.starts_with(prefix)) return std::nullopt;
    line.remove_prefix(prefix.size());
    const auto skip_blanks = [&line] {
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    };
    skip_blanks();
    std::uint32_t value = 0;
    std::size_t digits = 0;
    for (; digits < line.size() && line[digits] >= '0' && line[digits] <= '9'; ++digits) {
        if (digits == 9) return std::nullopt;
        value = value * 10 + static_cast<std::uint32_t>(line[digits] - '0');
    }
    if (digits == 0) return std::nullopt;
    line.remove_prefix(digits);
    skip_blanks();
    return value;
}

/// One component of a row in the newer run-length code. Gives what is wrong, or "".
const char* read_runs(std::string_view& rest, std::vector<Rgbe>& row, std::size_t component) {
    for (std::size_t x = 0; x < row.size();) {
        if (rest.size() < 2) return kCutShort;
        const auto code = static_cast<std::uint8_t>(rest[0]);
        const bool run = code > 128;
        const std::size_t count = run ? code - 128U : code;
        if (count == 0) return "a run of pixels has no length";
        if (count > row.size() - x) return "a run of pixels is longer than its row";
        if (!run && rest.size() < 1 + count) return kCutShort;
        for (std::size_t i = 0; i < count; ++i) {
            row[x++][component] = static_cast<std::uint8_t>(rest[run ? 1 : 1 + i]);
        }
        rest.remove_prefix(run ? 2 : 1 + count);
    }
    return "";
}

/// A row of plain pixels, with the older code's repeats (1, 1, 1, count; further ones count in
/// units of 256).
const char* read_flat(std::string_view& rest, std::vector<Rgbe>& row) {
    unsigned shift = 0;
    for (std::size_t x = 0; x < row.size();) {
        if (rest.size() < 4) return kCutShort;
        Rgbe pixel{};
        for (std::size_t c = 0; c < 4; ++c) pixel[c] = static_cast<std::uint8_t>(rest[c]);
        rest.remove_prefix(4);
        if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
            if (x == 0) return "a run of pixels has no pixel before it";
            const std::size_t count = shift > 16 ? row.size() : std::size_t{pixel[3]} << shift;
            if (count > row.size() - x) return "a run of pixels is longer than its row";
            for (std::size_t i = 0; i < count; ++i, ++x) row[x] = row[x - 1];
            shift += 8;
        } else {
            row[x++] = pixel;
            shift = 0;
        }
    }
    return "";
}

const char* read_row(std::string_view& rest, std::vector<Rgbe>& row) {
    const std::size_t width = row.size();
    const bool runs = width >= 8 && width < 32768 && rest.size() >= 4 && byte_at(rest, 0) == 2 &&
                      byte_at(rest, 1) == 2 && byte_at(rest, 2) < 128;
    if (!runs) return read_flat(rest, row);
    if (big_endian(rest, 2, 2) != width) {
        return "a row has another length than the picture";
    }
    rest.remove_prefix(4);
    for (std::size_t c = 0; c < 4; ++c) {
        if (const char* problem = read_runs(rest, row, c); *problem != '\0') return problem;
    }
    return "";
}

}  // namespace

bool is_radiance(std::string_view bytes) { return bytes.starts_with("#?"); }

RadianceHeader read_radiance_header(std::string_view bytes) {
    RadianceHeader header;
    const auto failed = [&header](const char* problem) {
        header.problem = problem;
        return header;
    };
    std::string_view rest = bytes;
    bool rgbe = false;
    for (;;) {
        const auto line = take_line(rest);
        if (!line) return failed(kCutShort);
        if (line->empty()) break;
        if (*line == "FORMAT=32-bit_rle_rgbe") rgbe = true;
        if (*line == "FORMAT=32-bit_rle_xyze") return failed("its pixels are XYZ, not RGB");
    }
    if (!rgbe) return failed("its header does not name its format");
    auto line = take_line(rest);
    if (!line) return failed(kCutShort);
    const auto height = take_side(*line, "-Y ");
    if (!height) return failed("its rows are not stored from the top");
    const auto width = take_side(*line, "+X ");
    if (!width || !line->empty()) return failed("its rows are not stored from the left");
    header.width = *width;
    header.height = *height;
    header.size = bytes.size() - rest.size();
    return header;
}

std::string decode_radiance(std::string_view bytes, const RadianceHeader& header,
                            std::vector<float>& pixels) {
    std::string_view rest = bytes.substr(header.size);
    // A row takes at least two bytes for 127 values of each of four components, or, with the older
    // repeats, one pixel and a repeat.
    const std::uint64_t row_bytes = header.width < 8 ? std::uint64_t{4} : std::uint64_t{8};
    if (rest.size() / row_bytes < header.height) return kCutShort;
    std::vector<Rgbe> row(header.width);
    pixels.reserve(std::size_t{header.width} * header.height * 3);
    for (std::uint32_t y = 0; y < header.height; ++y) {
        if (const char* problem = read_row(rest, row); *problem != '\0') return problem;
        for (const Rgbe& pixel : row) {
            const double scale = pixel[3] == 0 ? 0 : math::power_of_two(int{pixel[3]} - 136);
            for (std::size_t c = 0; c < 3; ++c) {
                pixels.push_back(static_cast<float>(pixel[c] * scale));
            }
        }
    }
    return {};
}

}  // namespace cobble::image
