// SPDX-License-Identifier: MIT
#include "ir/assets/image_decoder.hpp"

#include <stb/stb_image.h>

#include <cstring>
#include <limits>
#include <memory>

#include "ir/assets/image_integrity.hpp"
#include "ir/assets/stb_budget.hpp"

namespace cobble::ir {
namespace {

struct StbFree {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};

const stbi_uc* data_of(std::string_view bytes) {
    return reinterpret_cast<const stbi_uc*>(bytes.data());
}

// Room for headers, tables and palettes whatever the picture.
constexpr std::size_t kFixedBudget = std::size_t{64} << 20;

DecodedImage failed(DecodeStatus status, std::string reason) {
    return {status, std::move(reason), {}};
}

DecodedImage decoder_failed(std::string_view bytes) {
    const std::string_view format = image_format(bytes);
    const char* const said = stbi_failure_reason();
    const std::string_view why = said == nullptr ? "unknown" : said;
    if (why == "outofmem" || why == "output buffer limit") {
        return failed(DecodeStatus::kTooLarge, "it unpacks to more than its size allows");
    }
    if (why == "too large") return failed(DecodeStatus::kTooLarge, "it has too many pixels");
    return failed(DecodeStatus::kCorrupt, std::string(format.empty() ? "TGA" : format) +
                                              " data is damaged or of an unknown kind (" +
                                              std::string(why) + ")");
}

template <typename T>
bool all_texels_equal(const std::vector<T>& values) {
    for (std::size_t i = 3; i < values.size(); ++i) {
        if (values[i] != values[i - 3]) return false;
    }
    return true;
}

}  // namespace

std::optional<std::pair<std::uint32_t, std::uint32_t>> image_size(std::string_view bytes) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        return std::nullopt;
    }
    // A PNG's size stands at a fixed place; the decoder would not tell that of one it finds too
    // big.
    if (image_format(bytes) == "PNG" && bytes.size() >= 24 && bytes.substr(12, 4) == "IHDR") {
        const auto number = [&](std::size_t at) {
            std::uint32_t value = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
            }
            return value;
        };
        return std::pair{number(16), number(20)};
    }
    // Asking for a JPEG's size already reads its tables.
    if (image_format(bytes) == "JPEG" && !find_damage(bytes).empty()) return std::nullopt;
    const StbBudget budget(kFixedBudget);
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data_of(bytes), static_cast<int>(bytes.size()), &width, &height,
                              &channels) == 0) {
        return std::nullopt;
    }
    // BMP stores pictures that run downwards with a negative height.
    const auto magnitude = [](int n) {
        return n < 0 ? 0U - static_cast<std::uint32_t>(n) : static_cast<std::uint32_t>(n);
    };
    return std::pair{magnitude(width), magnitude(height)};
}

DecodedImage decode_image(std::string_view bytes, std::uint64_t max_pixels) {
    if (bytes.empty()) return failed(DecodeStatus::kCorrupt, "the file is empty");
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        return failed(DecodeStatus::kTooLarge, "files of 2 GiB and more cannot be read");
    }
    const auto size = image_size(bytes);
    if (!size) {
        const std::string_view format = image_format(bytes);
        if (format.empty()) {
            return failed(DecodeStatus::kCorrupt, "it is no BMP, PNG, JPEG, TGA or HDR picture");
        }
        std::string damage = find_damage(bytes);
        return failed(DecodeStatus::kCorrupt,
                      damage.empty()
                          ? "it is of a kind of " + std::string(format) + " that cannot be read"
                          : damage);
    }
    const std::uint32_t width = size->first;  // clang 14 lets no lambda use a structured binding
    const std::uint32_t height = size->second;
    const std::uint64_t pixels = std::uint64_t{width} * height;
    if (pixels == 0) return failed(DecodeStatus::kCorrupt, "it has no pixels");
    if (pixels > max_pixels) {
        return failed(DecodeStatus::kTooLarge,
                      "it claims " + std::to_string(width) + " x " + std::to_string(height) +
                          " pixels, and the limit is " + std::to_string(max_pixels));
    }
    if (std::string damage = find_damage(bytes); !damage.empty()) {
        return failed(DecodeStatus::kCorrupt, std::move(damage));
    }

    // At most: unpacked 16-bit RGBA, its unfiltered copy and its conversion to three channels, and
    // the joined data chunks while they grow.
    const StbBudget budget(kFixedBudget + static_cast<std::size_t>(pixels) * 40 + bytes.size() * 4);
    const int length = static_cast<int>(bytes.size());
    int x = 0;
    int y = 0;
    int channels = 0;
    DecodedImage result;
    result.image.width = width;
    result.image.height = height;
    const std::size_t count = static_cast<std::size_t>(pixels) * 3;
    const auto size_kept = [&] {
        return static_cast<std::uint32_t>(x) == width && static_cast<std::uint32_t>(y) == height;
    };
    if (stbi_is_hdr_from_memory(data_of(bytes), length) != 0) {
        const std::unique_ptr<float, StbFree> data(
            stbi_loadf_from_memory(data_of(bytes), length, &x, &y, &channels, 3));
        if (!data || !size_kept()) return decoder_failed(bytes);
        result.image.floats.assign(data.get(), data.get() + count);
        result.image.tag = ColorTag::kLinear;
        result.image.constant = all_texels_equal(result.image.floats);
    } else {
        const std::unique_ptr<stbi_uc, StbFree> data(
            stbi_load_from_memory(data_of(bytes), length, &x, &y, &channels, 3));
        if (!data || !size_kept()) return decoder_failed(bytes);
        result.image.bytes.assign(data.get(), data.get() + count);
        result.image.constant = all_texels_equal(result.image.bytes);
    }
    result.status = DecodeStatus::kOk;
    return result;
}

}  // namespace cobble::ir
