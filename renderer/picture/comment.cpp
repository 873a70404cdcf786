// SPDX-License-Identifier: MIT
#include "renderer/picture/comment.hpp"

#include <algorithm>
#include <cstdint>

#include "ir/image/bytes.hpp"
#include "ir/image/crc32.hpp"
#include "ir/image/magic.hpp"

namespace cobble::renderer {
namespace {

using image::big_endian;
using image::kExrMagic;
using image::kPngMagic;
using image::little_endian;
using image::put_big_endian;
using image::put_little_endian;

constexpr std::string_view kPngKeyword{"Comment\0", 8};
constexpr std::size_t kExrHeader = 8;  // the magic number and the version
constexpr std::string_view kExrName{"comments\0string\0", 16};
constexpr std::string_view kHdrPrefix = "# ";
constexpr std::size_t kTgaHeader = 18;

void add_to_png(std::string& bytes, std::string_view comment) {
    std::string chunk = "tEXt";
    chunk += kPngKeyword;
    chunk += comment;
    std::string framed;
    put_big_endian(framed, chunk.size() - 4, 4);
    framed += chunk;
    put_big_endian(framed, image::crc32(chunk), 4);
    // The header's chunk comes first: 13 bytes between 8 of length and name and 4 of checksum.
    bytes.insert(kPngMagic.size() + 8 + 13 + 4, framed);
}

std::string png_comment(std::string_view bytes) {
    std::size_t at = kPngMagic.size();
    while (bytes.size() - at >= 12) {
        const std::size_t length = big_endian(bytes, at, 4);
        if (length > bytes.size() - at - 12) break;
        const std::string_view name = bytes.substr(at + 4, 4);
        const std::string_view value = bytes.substr(at + 8, length);
        if (name == "tEXt" && value.starts_with(kPngKeyword)) {
            return std::string(value.substr(kPngKeyword.size()));
        }
        at += 12 + length;
    }
    return {};
}

/// An attribute at the front of `rest`, which it takes away; false at the header's end, or if the
/// bytes break off.
bool take_attribute(std::string_view& rest, std::string_view& name, std::string_view& value) {
    const std::size_t name_end = rest.find('\0');
    if (name_end == 0 || name_end == std::string_view::npos) return false;
    const std::size_t type_end = rest.find('\0', name_end + 1);
    if (type_end == std::string_view::npos || rest.size() - type_end < 5) return false;
    const std::size_t size = little_endian(rest, type_end + 1, 4);
    if (size > rest.size() - type_end - 5) return false;
    name = rest.substr(0, name_end);
    value = rest.substr(type_end + 5, size);
    rest.remove_prefix(type_end + 5 + size);
    return true;
}

void add_to_exr(std::string& bytes, std::string_view comment) {
    std::string attribute(kExrName);
    put_little_endian(attribute, comment.size(), 4);
    attribute += comment;
    bytes.insert(kExrHeader, attribute);
    // Behind the header stands where each chunk begins, and the first one begins behind that.
    std::string_view rest = std::string_view(bytes).substr(kExrHeader);
    std::string_view name;
    std::string_view value;
    while (take_attribute(rest, name, value)) {
    }
    std::size_t at = bytes.size() - rest.size() + 1;
    const std::size_t end = little_endian(bytes, at, 8) + attribute.size();
    for (; at < end; at += 8) {
        std::string moved;
        put_little_endian(moved, little_endian(bytes, at, 8) + attribute.size(), 8);
        bytes.replace(at, 8, moved);
    }
}

std::string exr_comment(std::string_view bytes) {
    std::string_view rest = bytes.substr(bytes.size() < kExrHeader ? bytes.size() : kExrHeader);
    std::string_view name;
    std::string_view value;
    while (take_attribute(rest, name, value)) {
        if (name == "comments") return std::string(value);
    }
    return {};
}

std::string hdr_comment(std::string_view bytes) {
    for (std::size_t at = bytes.find('\n'); at != std::string_view::npos;) {
        const std::size_t end = bytes.find('\n', ++at);
        const std::string_view line = bytes.substr(at, end - at);
        if (end == std::string_view::npos || line.empty()) break;
        if (line.starts_with(kHdrPrefix)) return std::string(line.substr(kHdrPrefix.size()));
        at = end;
    }
    return {};
}

/// The last line, if it can be a comment between two line ends.
std::string trailing_line(std::string_view bytes) {
    if (!bytes.ends_with('\n')) return {};
    bytes.remove_suffix(1);
    const std::string_view tail =
        bytes.substr(bytes.size() - std::min(bytes.size(), kMaxComment + 1));
    const std::size_t start = tail.rfind('\n');
    return start == std::string_view::npos ? std::string() : std::string(tail.substr(start + 1));
}

}  // namespace

void add_comment(std::string& bytes, PictureFormat format, std::string_view comment) {
    const std::string line = std::string(comment) + '\n';
    switch (format) {
        case PictureFormat::kPng:
            return add_to_png(bytes, comment);
        case PictureFormat::kExr:
            return add_to_exr(bytes, comment);
        case PictureFormat::kHdr:
            bytes.insert(bytes.find('\n') + 1, std::string(kHdrPrefix) + line);
            return;
        case PictureFormat::kTga:
            bytes[0] = static_cast<char>(comment.size());
            bytes.insert(kTgaHeader, comment);
            return;
        case PictureFormat::kBmp:
        case PictureFormat::kPfm:
            bytes += '\n' + line;
            return;
    }
}

std::string comment_of(std::string_view bytes) {
    if (bytes.starts_with(kPngMagic)) return png_comment(bytes);
    if (bytes.starts_with(kExrMagic)) return exr_comment(bytes);
    if (bytes.starts_with("#?")) return hdr_comment(bytes);
    if (bytes.starts_with("PF") || bytes.starts_with("Pf") || bytes.starts_with("BM")) {
        return trailing_line(bytes);
    }
    if (bytes.size() < kTgaHeader) return {};
    return std::string(bytes.substr(kTgaHeader, static_cast<std::uint8_t>(bytes[0])));
}

}  // namespace cobble::renderer
