// SPDX-License-Identifier: MIT
#include "tools/driver/pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "renderer/compat/pictures.hpp"
#include "renderer/picture/comment.hpp"
#include "tools/driver/disk_file_source.hpp"
#include "tools/driver/write_file.hpp"

namespace cobble::driver {
namespace {

// What the decoder takes as pixels, with four floats each, and a mebibyte of header.
constexpr std::uint64_t kMaxPictureFile = renderer::kMaxPixels * 16 + (1U << 20U);

std::string unknown_ending(const std::string& path) {
    if (path == "-") return "cannot write -: a picture goes to a file, not to standard output";
    return fmt::format(
        "cannot write {}: a picture's name ends in .png, .pfm, .hdr, .exr, .bmp or .tga", path);
}

}  // namespace

ReadPicture read_picture(const std::string& path) {
    ReadPicture result;
    DiskFileSource disk;
    const source::ReadResult file = disk.read(path, kMaxPictureFile);
    if (file.status != source::ReadStatus::kOk) {
        result.problem = fmt::format("cannot read {}: {}", path, file.reason);
        return result;
    }
    renderer::Decoded decoded = renderer::decode(file.bytes);
    if (!decoded.error.empty()) {
        result.problem = fmt::format("cannot read {}: {}", path, decoded.error);
        return result;
    }
    result.plane = std::move(decoded.plane);
    result.eight_bit = decoded.eight_bit;
    result.comment = renderer::comment_of(file.bytes);
    return result;
}

std::string write_picture(const std::string& path, const renderer::Plane32& plane,
                          const renderer::EncodeOptions& options) {
    const auto format = renderer::picture_format(path);
    if (!format) return unknown_ending(path);
    const renderer::Encoded encoded = renderer::encode(plane, *format, options);
    if (!encoded.error.empty()) return fmt::format("cannot write {}: {}", path, encoded.error);
    return write_file(path, encoded.bytes);
}

std::string check_picture_path(const std::string& path, std::uint32_t width, std::uint32_t height,
                               std::uint32_t channels) {
    const auto format = renderer::picture_format(path);
    if (!format) return unknown_ending(path);
    const std::string problem = renderer::problem_of_size(width, height);
    if (!problem.empty()) return fmt::format("cannot write {}: {}", path, problem);
    const std::uint64_t pixels = std::uint64_t{width} * height;
    // The sizes of the formats without compression are known beforehand.
    std::uint64_t bytes = 0;
    if (*format == renderer::PictureFormat::kPfm) bytes = pixels * 4 * channels;
    if (*format == renderer::PictureFormat::kBmp) bytes = pixels * 3;
    if (*format == renderer::PictureFormat::kTga) bytes = pixels * 3;
    return check_writable(path, bytes);
}

bool keeps_bytes(const std::string& path) {
    const auto format = renderer::picture_format(path);
    return format == renderer::PictureFormat::kPng || format == renderer::PictureFormat::kBmp ||
           format == renderer::PictureFormat::kTga;
}

renderer::Plane32 depth_as_grey(const renderer::Plane32& depth, ir::Compat compat,
                                std::optional<std::pair<double, double>> range) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const float t : depth.values) {
        if (!std::isfinite(t)) continue;
        low = std::min(low, double{t});
        high = std::max(high, double{t});
    }
    if (range) {
        low = range->first;
        high = range->second;
    } else if (!(low <= high)) {
        low = 0;  // nothing but misses, which are far beyond any range
        high = 1;
    } else if (low == high) {
        high = 2 * low + 1;  // a flat picture has no range: all of it is near
    }
    return renderer::compat_depth_picture(depth, compat, low, high);
}

renderer::Plane32 normals_as_color(const renderer::Plane32& normals, ir::Compat compat) {
    // Cobble's own are written as in the edition of 2016.
    const bool own = compat == ir::Compat::kNone;
    return renderer::compat_normals_picture(normals, own ? ir::Compat::kFa2016 : compat);
}

renderer::Plane32 counts_as_grey(const renderer::Plane32& counts, std::uint32_t samples) {
    renderer::Plane32 grey = counts;
    for (float& count : grey.values) count /= static_cast<float>(samples);
    return grey;
}

}  // namespace cobble::driver
