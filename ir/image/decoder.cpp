// SPDX-License-Identifier: MIT
#include "ir/image/decoder.hpp"

#include <stb/stb_image.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "ir/image/bytes.hpp"
#include "ir/image/integrity.hpp"
#include "ir/image/radiance.hpp"
#include "ir/image/stb_budget.hpp"

namespace cobble::image {
namespace {

struct StbFree {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};
template <typename T>
using Owned = std::unique_ptr<T, StbFree>;

/// The library counts in int.
constexpr std::size_t kMaxBytes = std::numeric_limits<int>::max();

// Room for headers, tables and palettes whatever the picture.
constexpr std::size_t kFixedBudget = std::size_t{64} << 20;

// At most: unpacked 16-bit RGBA, its unfiltered copy and its conversion to three channels.
constexpr std::uint64_t kBytesPerPixel = 40;

// However large the picture, so that a small file cannot take all memory: enough for the largest
// pictures of 8 bits that the library reads (2^30 bytes), three times over.
constexpr std::uint64_t kMostWorking = std::uint64_t{4} << 30;

/// What the library reads of a file.
struct StbInput {
    explicit StbInput(std::string_view bytes)
        : data(reinterpret_cast<const stbi_uc*>(bytes.data())),
          size(static_cast<int>(bytes.size())) {}
    const stbi_uc* data;
    int size;
};

Decoded failed(Status status, std::string reason) {
    Decoded result;
    result.status = status;
    result.reason = std::move(reason);
    return result;
}

Decoded decoder_failed(std::string_view bytes) {
    const char* const said = stbi_failure_reason();
    const std::string_view why = said == nullptr ? "unknown" : said;
    if (why == "outofmem" || why == "output buffer limit") {
        return failed(Status::kTooLarge, "it unpacks to more than its size allows");
    }
    if (why == "too large") return failed(Status::kTooLarge, "it has too many pixels");
    const std::string_view format = image_format(bytes);
    return failed(Status::kCorrupt, std::string(format.empty() ? "TGA" : format) +
                                        " data is damaged or of an unknown kind (" +
                                        std::string(why) + ")");
}

Decoded no_header(std::string_view bytes) {
    const std::string_view format = image_format(bytes);
    if (format.empty()) {
        return failed(Status::kUnknown, "it is no BMP, PNG, JPEG, TGA or HDR picture");
    }
    std::string damage = find_damage(bytes);
    if (damage.empty()) {
        damage = "it is of a kind of " + std::string(format) + " that cannot be read";
    }
    return failed(Status::kCorrupt, std::move(damage));
}

Decoded decode_hdr(std::string_view bytes) {
    const RadianceHeader header = read_radiance_header(bytes);
    Decoded result;
    result.reason = decode_radiance(bytes, header, result.floats);
    if (!result.reason.empty()) return failed(Status::kCorrupt, std::move(result.reason));
    result.width = header.width;
    result.height = header.height;
    result.status = Status::kOk;
    return result;
}

}  // namespace

std::optional<Header> read_header(std::string_view bytes) {
    const std::string_view format = image_format(bytes);
    if (format == "HDR") {
        const RadianceHeader header = read_radiance_header(bytes);
        if (!header.problem.empty()) return std::nullopt;
        return Header{header.width, header.height, true};
    }
    if (bytes.size() > kMaxBytes) return std::nullopt;
    // A PNG's size stands at a fixed place; the decoder would not tell that of one it finds too
    // big.
    if (format == "PNG" && bytes.size() >= 24 && bytes.substr(12, 4) == "IHDR") {
        return Header{static_cast<std::uint32_t>(big_endian(bytes, 16, 4)),
                      static_cast<std::uint32_t>(big_endian(bytes, 20, 4)), false};
    }
    // Asking for a JPEG's size already reads its tables.
    if (format == "JPEG" && !find_damage(bytes).empty()) return std::nullopt;
    const StbBudget budget(kFixedBudget);
    const StbInput input(bytes);
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(input.data, input.size, &width, &height, &channels) == 0) {
        return std::nullopt;
    }
    // BMP stores pictures that run downwards with a negative height.
    const auto magnitude = [](int n) {
        return n < 0 ? 0U - static_cast<std::uint32_t>(n) : static_cast<std::uint32_t>(n);
    };
    return Header{magnitude(width), magnitude(height), false};
}

std::string size_problem(std::uint64_t width, std::uint64_t height, std::uint64_t max_pixels) {
    if (width == 0 || height == 0) return "it has no pixels";
    if (width <= max_pixels / height) return {};
    return "it claims " + std::to_string(width) + " x " + std::to_string(height) +
           " pixels, and the limit is " + std::to_string(max_pixels) + " pixels";
}

Decoded decode(std::string_view bytes, const Options& options) {
    if (bytes.empty()) return failed(Status::kCorrupt, "the file is empty");
    const auto header = read_header(bytes);
    if (!header && bytes.size() > kMaxBytes) {
        return failed(Status::kTooLarge, "files of 2 GiB and more cannot be read");
    }
    if (!header) return no_header(bytes);
    const std::uint32_t width = header->width;
    const std::uint32_t height = header->height;
    if (std::string problem = size_problem(width, height, options.max_pixels); !problem.empty()) {
        const bool none = width == 0 || height == 0;
        return failed(none ? Status::kCorrupt : Status::kTooLarge, std::move(problem));
    }
    if (header->floats) return decode_hdr(bytes);
    if (std::string damage = find_damage(bytes); !damage.empty()) {
        return failed(Status::kCorrupt, std::move(damage));
    }

    const std::uint64_t pixels = std::uint64_t{width} * height;
    // Four times the file: its joined data chunks while they grow.
    const StbBudget budget(
        static_cast<std::size_t>(std::min(pixels, kMostWorking / kBytesPerPixel) * kBytesPerPixel) +
        kFixedBudget + bytes.size() * 4);
    const StbInput input(bytes);
    int x = 0;
    int y = 0;
    int channels = 0;
    Decoded result;
    const auto keep = [&](auto* data, auto& kept) {
        if (data == nullptr || static_cast<std::uint32_t>(x) != width ||
            static_cast<std::uint32_t>(y) != height) {
            return false;
        }
        kept.assign(data, data + static_cast<std::size_t>(pixels) * 3);
        return true;
    };
    bool kept = false;
    if (options.sixteen_bits && stbi_is_16_bit_from_memory(input.data, input.size) != 0) {
        const Owned<stbi_us> data(
            stbi_load_16_from_memory(input.data, input.size, &x, &y, &channels, 3));
        kept = keep(data.get(), result.words);
    } else {
        const Owned<stbi_uc> data(
            stbi_load_from_memory(input.data, input.size, &x, &y, &channels, 3));
        kept = keep(data.get(), result.bytes);
    }
    if (!kept) return decoder_failed(bytes);
    result.width = width;
    result.height = height;
    result.status = Status::kOk;
    return result;
}

std::optional<std::string> inflate(std::string_view bytes, std::size_t size) {
    if (bytes.size() > kMaxBytes || size > kMaxBytes) return std::nullopt;
    std::string out(size, '\0');
    const int written = stbi_zlib_decode_buffer(out.data(), static_cast<int>(size), bytes.data(),
                                                static_cast<int>(bytes.size()));
    if (written < 0 || static_cast<std::size_t>(written) != size) return std::nullopt;
    return out;
}

}  // namespace cobble::image
