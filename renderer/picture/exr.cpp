// SPDX-License-Identifier: MIT
// OpenEXR files of one part of scan lines, after the OpenEXR file layout page: a magic number, a
// version, attributes, a table of chunk offsets, chunks of 1 or 16 lines. In a chunk each line
// holds each channel's values in the order of the channels' names. Compressed chunks are first
// reordered (bytes of even index, then those of odd index) and replaced by differences.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>

#include "ir/image/bytes.hpp"
#include "ir/image/decoder.hpp"
#include "ir/image/magic.hpp"
#include "renderer/picture/codecs.hpp"

namespace cobble::renderer {
namespace {

using image::little_endian;
using image::put_little_endian;

enum Compression : std::uint8_t { kNone = 0, kRle = 1, kZips = 2, kZip = 3 };
enum PixelType : std::uint32_t { kUint = 0, kHalf = 1, kFloat = 2 };

constexpr std::uint32_t kVersion = 2;
/// Version flag that only allows names over 31 bytes; the others (tiles, deep data, parts) change
/// the layout.
constexpr std::uint32_t kLongNames = 0x400;

constexpr std::size_t lines_per_chunk(std::uint8_t compression) {
    return compression == kZip ? 16 : 1;
}

void put_attribute(std::string& out, std::string_view name, std::string_view type,
                   std::string_view value) {
    out.append(name).push_back('\0');
    out.append(type).push_back('\0');
    put_little_endian(out, value.size(), 4);
    out += value;
}

std::string packed(std::initializer_list<std::uint32_t> words) {
    std::string out;
    for (const std::uint32_t word : words) put_little_endian(out, word, 4);
    return out;
}

constexpr std::uint8_t u8(char c) { return static_cast<std::uint8_t>(c); }

std::string reordered(std::string_view raw) {
    std::string out;
    out.reserve(raw.size());
    for (std::size_t i = 0; i < raw.size(); i += 2) out.push_back(raw[i]);
    for (std::size_t i = 1; i < raw.size(); i += 2) out.push_back(raw[i]);
    for (std::size_t i = out.size(); i-- > 1;) {
        out[i] = static_cast<char>(u8(out[i]) - u8(out[i - 1]) + 128);
    }
    return out;
}

std::string restored(std::string differences) {
    for (std::size_t i = 1; i < differences.size(); ++i) {
        differences[i] = static_cast<char>(u8(differences[i]) + u8(differences[i - 1]) - 128);
    }
    std::string out(differences.size(), '\0');
    const std::size_t half = (out.size() + 1) / 2;
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = differences[i % 2 == 0 ? i / 2 : half + i / 2];
    }
    return out;
}

/// Run lengths: a negative count is followed by as many plain bytes, another by one byte that
/// stands count + 1 times.
std::optional<std::string> expanded_runs(std::string_view bytes, std::size_t size) {
    std::string out;
    while (!bytes.empty()) {
        const int byte = static_cast<unsigned char>(bytes.front());
        const int code = byte < 128 ? byte : byte - 256;
        bytes.remove_prefix(1);
        const auto count = static_cast<std::size_t>(code < 0 ? -code : code + 1);
        if (out.size() + count > size || bytes.size() < (code < 0 ? count : 1)) return std::nullopt;
        if (code < 0) {
            out += bytes.substr(0, count);
        } else {
            out.append(count, bytes.front());
        }
        bytes.remove_prefix(code < 0 ? count : 1);
    }
    if (out.size() != size) return std::nullopt;
    return out;
}

/// IEEE 754 half precision, exactly.
float float_of_half(std::uint32_t half) {
    const std::uint32_t sign = (half & 0x8000) << 16;
    const std::uint32_t exponent = half >> 10 & 31;
    const std::uint32_t mantissa = half & 0x3ff;
    if (exponent == 0) {
        const float magnitude = static_cast<float>(mantissa) * 0x1p-24F;
        return sign != 0 ? -magnitude : magnitude;
    }
    const std::uint32_t wide = exponent == 31 ? 255 : exponent + 127 - 15;
    return std::bit_cast<float>(sign | wide << 23 | mantissa << 13);
}

struct Channel {
    std::uint32_t type = kFloat;
    /// The component of the result that it fills: 0 to 2, 3 for all (luminance), 4 for none.
    std::uint32_t target = 4;
    [[nodiscard]] std::size_t bytes() const { return type == kHalf ? 2 : 4; }
};

struct Header {
    std::vector<Channel> channels;
    std::uint8_t compression = 0xff;
    std::int64_t x0 = 0, y0 = 0, x1 = -1, y1 = -1;
};

/// Reads from the front of the file; after a failure everything reads as nothing.
class Reader {
  public:
    explicit Reader(std::string_view bytes) : rest_(bytes) {}
    [[nodiscard]] bool ok() const { return ok_; }
    std::string_view bytes(std::size_t count) {
        if (count > rest_.size()) return fail();
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return taken;
    }
    std::uint32_t u32() {
        const std::string_view taken = bytes(4);
        return ok_ ? static_cast<std::uint32_t>(little_endian(taken, 0, 4)) : 0;
    }
    std::string_view name() {
        const std::size_t end = rest_.find('\0');
        if (end == std::string_view::npos) return fail();
        const std::string_view taken = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return taken;
    }
    [[nodiscard]] std::string_view rest() const { return rest_; }

  private:
    std::string_view fail() {
        ok_ = false;
        rest_ = {};
        return {};
    }
    std::string_view rest_;
    bool ok_ = true;
};

std::string read_channels(std::string_view value, Header& header) {
    Reader reader(value);
    std::uint32_t seen = 0;
    for (std::string_view name = reader.name(); !name.empty(); name = reader.name()) {
        Channel channel;
        channel.type = reader.u32();
        reader.u32();  // "perceptually linear" and padding
        if (reader.u32() != 1 || reader.u32() != 1) return "EXR channels of less size are not read";
        if (channel.type > kFloat) return "the EXR file has a channel of unknown type";
        channel.target = name == "R" ? 0 : name == "G" ? 1 : name == "B" ? 2 : name == "Y" ? 3 : 4;
        seen |= 1U << channel.target;
        header.channels.push_back(channel);
    }
    if (!reader.ok()) return "the EXR file's header is malformed";
    if ((seen & 7U) != 7U && (seen & 8U) == 0) return "the EXR file has no R, G and B, and no Y";
    return {};
}

std::string read_header(Reader& reader, Header& header) {
    for (std::string_view name = reader.name(); !name.empty(); name = reader.name()) {
        reader.name();  // its type follows from its name
        const std::string_view value = reader.bytes(reader.u32());
        if (!reader.ok()) break;
        if (name == "channels") {
            header.channels.clear();
            if (std::string error = read_channels(value, header); !error.empty()) return error;
        } else if (name == "compression" && value.size() == 1) {
            header.compression = u8(value[0]);
        } else if (name == "dataWindow" && value.size() == 16) {
            const auto corner = [&value](std::size_t i) {
                return std::int64_t{static_cast<std::int32_t>(little_endian(value, i * 4, 4))};
            };
            header.x0 = corner(0), header.y0 = corner(1);
            header.x1 = corner(2), header.y1 = corner(3);
        }
    }
    if (!reader.ok() || header.channels.empty() || header.x1 < header.x0 || header.y1 < header.y0) {
        return "the EXR file's header is malformed";
    }
    if (header.compression > kZip) {
        return "EXR files are read uncompressed, run-length or ZIP compressed only";
    }
    return {};
}

float value_of(std::string_view raw, std::size_t at, std::uint32_t type) {
    if (type == kHalf) return float_of_half(static_cast<std::uint32_t>(little_endian(raw, at, 2)));
    const auto bits = static_cast<std::uint32_t>(little_endian(raw, at, 4));
    return type == kUint ? static_cast<float>(bits) : std::bit_cast<float>(bits);
}

/// The lines of one chunk, from `y` (0 for the first of the picture) on.
void store_lines(std::string_view raw, const Header& header, std::size_t y, std::size_t lines,
                 Plane32& plane) {
    std::size_t at = 0;
    for (std::size_t line = y; line < y + lines; ++line) {
        for (const Channel& channel : header.channels) {
            for (std::size_t x = 0; x < plane.width; ++x, at += channel.bytes()) {
                if (channel.target > 3) continue;
                float* pixel = &plane.values[(line * plane.width + x) * 3];
                const float value = value_of(raw, at, channel.type);
                const std::uint32_t first = channel.target % 3;
                for (std::uint32_t c = first; c <= (channel.target == 3 ? 2 : first); ++c) {
                    pixel[c] = value;
                }
            }
        }
    }
}

std::optional<std::string> unpacked(std::string_view data, std::uint8_t compression,
                                    std::size_t size) {
    // What would not have become smaller is stored as it is.
    if (data.size() == size) return std::string(data);
    std::optional<std::string> raw;
    if (compression == kRle) raw = expanded_runs(data, size);
    if (compression == kZip || compression == kZips) raw = image::inflate(data, size);
    if (raw) raw = restored(std::move(*raw));
    return raw;
}

Decoded failed(std::string message) { return {{}, false, false, std::move(message)}; }

}  // namespace

Encoded encode_exr(const Plane32& plane) {
    const bool grey = plane.channels == 1;
    Encoded result;
    std::string& out = result.bytes;
    out = image::kExrMagic;
    put_little_endian(out, kVersion, 4);
    std::string channels;
    for (const std::string_view name : {"B", "G", "R", "Y"}) {
        if ((name == "Y") != grey) continue;
        channels.append(name).push_back('\0');
        channels += packed({kFloat, 0, 1, 1});
    }
    channels.push_back('\0');
    const std::string window = packed({0, 0, plane.width - 1, plane.height - 1});
    constexpr std::uint32_t kOne = std::bit_cast<std::uint32_t>(1.0F);
    put_attribute(out, "channels", "chlist", channels);
    put_attribute(out, "compression", "compression", std::string(1, static_cast<char>(kZip)));
    put_attribute(out, "dataWindow", "box2i", window);
    put_attribute(out, "displayWindow", "box2i", window);
    put_attribute(out, "lineOrder", "lineOrder", std::string(1, '\0'));
    put_attribute(out, "pixelAspectRatio", "float", packed({kOne}));
    put_attribute(out, "screenWindowCenter", "v2f", packed({0, 0}));
    put_attribute(out, "screenWindowWidth", "float", packed({kOne}));
    out.push_back('\0');

    const std::size_t step = lines_per_chunk(kZip);
    const std::size_t chunks = (plane.height + step - 1) / step;
    std::size_t table = out.size();
    out.resize(out.size() + chunks * 8);
    for (std::size_t y = 0; y < plane.height; y += step, table += 8) {
        std::string raw;
        for (std::size_t line = y; line < y + step && line < plane.height; ++line) {
            for (std::uint32_t c = plane.channels; c-- > 0;) {
                for (std::size_t x = 0; x < plane.width; ++x) {
                    const float value = plane.values[(line * plane.width + x) * plane.channels + c];
                    put_little_endian(raw, std::bit_cast<std::uint32_t>(value), 4);
                }
            }
        }
        const std::string small = deflate(reordered(raw));
        const std::string& data = !small.empty() && small.size() < raw.size() ? small : raw;
        std::string offset;
        put_little_endian(offset, out.size(), 8);
        out.replace(table, 8, offset);
        put_little_endian(out, y, 4);
        put_little_endian(out, data.size(), 4);
        out += data;
    }
    return result;
}

Decoded decode_exr(std::string_view bytes, std::uint64_t max_pixels) {
    Reader reader(bytes);
    reader.u32();
    const std::uint32_t version = reader.u32();
    if (!reader.ok() || (version & 0xff) != kVersion || (version & ~(0xff | kLongNames)) != 0) {
        return failed("only EXR files of one part of scan lines are read");
    }
    Header header;
    if (std::string error = read_header(reader, header); !error.empty()) return failed(error);
    const auto width = static_cast<std::uint64_t>(header.x1 - header.x0 + 1);
    const auto height = static_cast<std::uint64_t>(header.y1 - header.y0 + 1);
    if (std::string error = image::size_problem(width, height, max_pixels); !error.empty()) {
        return failed(std::move(error));
    }
    std::size_t line_bytes = 0;
    for (const Channel& channel : header.channels) line_bytes += channel.bytes() * width;

    constexpr const char* kShort = "the EXR file breaks off before its last line";
    const std::size_t step = lines_per_chunk(header.compression);
    const std::size_t chunks = (height + step - 1) / step;
    const std::string_view table = reader.bytes(chunks * 8);
    if (!reader.ok()) return failed(kShort);
    // zlib packs at most about 1032 to 1 and run lengths 64 to 1: no memory for what cannot be.
    constexpr std::uint64_t kBestRatio = 1100;
    if (reader.rest().size() < line_bytes * height / kBestRatio) return failed(kShort);

    Decoded result;
    result.plane =
        make_plane(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
    std::vector<bool> done(chunks);
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        const std::uint64_t offset = little_endian(table, chunk * 8, 8);
        if (offset > bytes.size()) return failed(kShort);
        Reader at(bytes.substr(offset));
        const std::int64_t y = std::int64_t{static_cast<std::int32_t>(at.u32())} - header.y0;
        const std::string_view data = at.bytes(at.u32());
        if (!at.ok()) return failed(kShort);
        const auto line = static_cast<std::uint64_t>(y);
        if (y < 0 || line >= height || line % step != 0 || done[line / step]) {
            return failed("the EXR file has a line out of place");
        }
        done[line / step] = true;
        const std::size_t lines = height - line < step ? height - line : step;
        const auto raw = unpacked(data, header.compression, lines * line_bytes);
        if (!raw) return failed("the EXR file's compressed lines are corrupt");
        store_lines(*raw, header, line, lines, result.plane);
    }
    return result;
}

}  // namespace cobble::renderer
