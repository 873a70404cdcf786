// SPDX-License-Identifier: MIT
#include "renderer/picture/picture_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ir/image/decoder.hpp"
#include "ir/image/magic.hpp"
#include "ir/math/srgb.hpp"
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

/// Entry k - 1: the light at which a display byte, rounded, steps from k - 1 to k.
std::array<double, 255> srgb_steps() {
    std::array<double, 255> steps{};
    for (std::size_t k = 1; k <= 255; ++k) {
        steps[k - 1] = math::srgb_to_linear((static_cast<double>(k) - 0.5) / 255);
    }
    return steps;
}

/// NaN fails the first comparison and becomes 0; a float is turned into an integer only once it is
/// known to fit.
class Quantiser {
  public:
    explicit Quantiser(const EncodeOptions& options)
        : quantise_(options.quantise), srgb_(options.encode_srgb) {
        if (srgb_) steps_ = srgb_steps();
    }
    [[nodiscard]] std::uint8_t byte_of(float value) const {
        if (!(value > 0)) return 0;
        if (value >= 1) return 255;
        if (quantise_ == Quantise::kTruncate) {
            // The published programs multiply floats.
            return static_cast<std::uint8_t>(value * 255.0F);
        }
        if (srgb_) {
            const auto* step = std::upper_bound(steps_.begin(), steps_.end(), double{value});
            return static_cast<std::uint8_t>(step - steps_.begin());
        }
        return static_cast<std::uint8_t>(255.0 * static_cast<double>(value) + 0.5);
    }

  private:
    Quantise quantise_;
    bool srgb_;
    std::array<double, 255> steps_{};
};

ByteImage quantised(const Plane32& plane, const EncodeOptions& options) {
    const Quantiser quantiser(options);
    ByteImage image{plane.width, plane.height, plane.channels, {}};
    image.bytes.reserve(plane.values.size());
    for (const float value : plane.values) {
        image.bytes.push_back(static_cast<char>(quantiser.byte_of(value)));
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

template <typename T>
void append_scaled(Plane32& plane, const std::vector<T>& from, float largest) {
    plane.values.reserve(from.size());
    for (const T value : from) plane.values.push_back(static_cast<float>(value) / largest);
}

}  // namespace

std::optional<PictureFormat> picture_format(std::string_view path) {
    for (const Ending& ending : kEndings) {
        if (ends_with_ignoring_case(path, ending.text)) return ending.format;
    }
    return std::nullopt;
}

Plane32 make_plane(std::uint32_t width, std::uint32_t height) {
    Plane32 plane{width, height, 3, {}};
    plane.values.resize(std::size_t{width} * height * 3);
    return plane;
}

std::string problem_of_size(std::uint64_t width, std::uint64_t height) {
    if (width <= kMaxSide && height <= kMaxSide && width * height <= kMaxPixels) return {};
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
    if (std::string problem = problem_of_size(plane.width, plane.height); !problem.empty()) {
        return {{}, std::move(problem)};
    }
    Encoded encoded = encode_checked(plane, format, options);
    if (encoded.error.empty() && !options.comment.empty()) {
        add_comment(encoded.bytes, format, options.comment);
    }
    return encoded;
}

Decoded decode(std::string_view bytes, std::uint64_t max_pixels) {
    if (bytes.starts_with("PF") || bytes.starts_with("Pf")) return decode_pfm(bytes, max_pixels);
    if (bytes.starts_with(image::kExrMagic)) return decode_exr(bytes, max_pixels);
    image::Decoded image = image::decode(bytes, {max_pixels, true});
    Decoded result;
    if (image.status == image::Status::kUnknown) {
        result.error = "it is no PNG, BMP, TGA, JPEG, PFM, HDR or EXR picture";
    }
    if (image.status != image::Status::kOk) {
        if (result.error.empty()) result.error = std::move(image.reason);
        return result;
    }
    result.eight_bit = !image.bytes.empty();
    result.display = image.floats.empty();
    result.plane = {image.width, image.height, 3, std::move(image.floats)};
    if (!image.bytes.empty()) append_scaled(result.plane, image.bytes, 255.0F);
    if (!image.words.empty()) append_scaled(result.plane, image.words, 65535.0F);
    return result;
}

}  // namespace cobble::renderer
