// SPDX-License-Identifier: MIT
#include "renderer/picture/picture_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "renderer/picture/codecs.hpp"
#include "renderer/picture/comment.hpp"

namespace cobble::renderer {
namespace {

struct Ending {
    std::string_view text;
    PictureFormat format;
};
constexpr std::array<Ending, 6> kEndings{{{".png", PictureFormat::kPng},
                                          {".bmp", PictureFormat::kBmp},
                                          {".tga", PictureFormat::kTga},
                                          {".pfm", PictureFormat::kPfm},
                                          {".hdr", PictureFormat::kHdr},
                                          {".exr", PictureFormat::kExr}}};

/// The largest side that every 8-bit format and its libraries hold without overflow.
constexpr std::uint32_t kMaxSide = 65535;

bool ends_with_ignoring_case(std::string_view path, std::string_view ending) {
    if (path.size() < ending.size()) return false;
    const std::string_view tail = path.substr(path.size() - ending.size());
    for (std::size_t i = 0; i < ending.size(); ++i) {
        const char c = tail[i];
        const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        if (lower != ending[i]) return false;
    }
    return true;
}

/// x^(1/5) for x in [0.01, 1] by Newton's method from 1, which approaches from above and has
/// settled to the last bits after 20 steps.
constexpr double fifth_root(double x) {
    double root = 1;
    for (int i = 0; i < 20; ++i) {
        const double square = root * root;
        root -= (root * square * square - x) / (5 * square * square);
    }
    return root;
}

/// IEC 61966-2-1: display value to light. y^2.4 = y^2 (y^2)^(1/5).
constexpr double linear_of_srgb(double display) {
    if (display <= 0.04045) return display / 12.92;
    const double y = (display + 0.055) / 1.055;
    return y * y * fifth_root(y * y);
}

/// Entry k - 1: the light at which a display byte, rounded, steps from k - 1 to k.
constexpr std::array<double, 255> kSrgbSteps = [] {
    std::array<double, 255> steps{};
    for (std::size_t k = 1; k <= 255; ++k) {
        steps[k - 1] = linear_of_srgb((static_cast<double>(k) - 0.5) / 255);
    }
    return steps;
}();

std::uint8_t srgb_byte_of(double light) {
    const auto* step = std::upper_bound(kSrgbSteps.begin(), kSrgbSteps.end(), light);
    return static_cast<std::uint8_t>(step - kSrgbSteps.begin());
}

/// NaN fails the first comparison and becomes 0; a float is turned into an integer only once it is
/// known to fit.
std::uint8_t byte_of(float value, const EncodeOptions& options) {
    if (!(value > 0)) return 0;
    if (value >= 1) return 255;
    if (options.quantise == Quantise::kTruncate) {
        // The published programs multiply floats.
        return static_cast<std::uint8_t>(value * 255.0F);
    }
    if (options.encode_srgb) return srgb_byte_of(static_cast<double>(value));
    return static_cast<std::uint8_t>(255.0 * static_cast<double>(value) + 0.5);
}

ByteImage quantised(const Plane32& plane, const EncodeOptions& options) {
    ByteImage image{plane.width, plane.height, plane.channels, {}};
    image.bytes.reserve(plane.values.size());
    for (const float value : plane.values) {
        image.bytes.push_back(static_cast<char>(byte_of(value, options)));
    }
    return image;
}

/// A plane whose values match its size, and whose size is that of a file.
Encoded encode_checked(const Plane32& plane, PictureFormat format, const EncodeOptions& options) {
    switch (format) {
        case PictureFormat::kPng:
            return encode_png(quantised(plane, options));
        case PictureFormat::kBmp:
            return encode_bmp(quantised(plane, options));
        case PictureFormat::kTga:
            return encode_tga(quantised(plane, options));
        case PictureFormat::kPfm:
            return encode_pfm(plane);
        case PictureFormat::kHdr:
            return encode_hdr(plane);
        case PictureFormat::kExr:
            return encode_exr(plane);
    }
    return {{}, "unknown picture format"};
}

}  // namespace

std::optional<PictureFormat> picture_format(std::string_view path) {
    for (const Ending& ending : kEndings) {
        if (ends_with_ignoring_case(path, ending.text)) return ending.format;
    }
    return std::nullopt;
}

std::string size_error(std::uint64_t width, std::uint64_t height) {
    if (width == 0 || height == 0) return "the picture has no pixels";
    if (width > kMaxPixels || height > kMaxPixels || width * height > kMaxPixels) {
        return fmt::format("the picture has {} x {} pixels, more than the {} that are read", width,
                           height, kMaxPixels);
    }
    return {};
}

Plane32 make_plane(std::uint32_t width, std::uint32_t height) {
    Plane32 plane{width, height, 3, {}};
    plane.values.resize(std::size_t{width} * height * 3);
    return plane;
}

std::string problem_of_size(std::uint64_t width, std::uint64_t height, std::uint32_t channels) {
    // The libraries count bytes in 32 bits with a sign; no number of a picture takes more than 4.
    constexpr std::uint64_t kMaxValues = std::numeric_limits<std::int32_t>::max() / 4;
    if (width <= kMaxSide && height <= kMaxSide && width * height * channels <= kMaxValues) {
        return {};
    }
    return fmt::format("a picture of {} x {} pixels is too large for a file", width, height);
}

Encoded encode(const Plane32& plane, PictureFormat format, const EncodeOptions& options) {
    if (plane.channels != 1 && plane.channels != 3) {
        return {{}, fmt::format("a picture has 1 or 3 channels, not {}", plane.channels)};
    }
    if (plane.width == 0 || plane.height == 0 ||
        plane.values.size() != std::size_t{plane.width} * plane.height * plane.channels) {
        return {{}, "the picture has no pixels"};
    }
    if (std::string problem = problem_of_size(plane.width, plane.height, plane.channels);
        !problem.empty()) {
        return {{}, std::move(problem)};
    }
    Encoded encoded = encode_checked(plane, format, options);
    if (encoded.error.empty() && !options.comment.empty()) {
        add_comment(encoded.bytes, format, options.comment);
    }
    return encoded;
}

Decoded decode(std::string_view bytes) {
    if (bytes.empty()) return {{}, false, false, "the file is empty"};
    if (bytes.starts_with("PF") || bytes.starts_with("Pf")) return decode_pfm(bytes);
    if (bytes.starts_with("#?")) return decode_hdr(bytes);
    if (bytes.starts_with("\x76\x2f\x31\x01")) return decode_exr(bytes);
    if (std::string error = truncation_of(bytes); !error.empty()) {
        return {{}, false, false, std::move(error)};
    }
    return decode_bitmap(bytes);
}

}  // namespace cobble::renderer
