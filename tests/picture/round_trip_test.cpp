// SPDX-License-Identifier: MIT
// What is written is read back, by ourselves and by others' readers.
#include <doctest/doctest.h>
#include <tinyexr.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "renderer/picture/picture_io.hpp"
#include "tests/picture/sample.hpp"

namespace cobble::renderer {
namespace {

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST_CASE("the ending names the format, in any case") {
    CHECK(picture_format("a/b.png") == PictureFormat::kPng);
    CHECK(picture_format("B.PnG") == PictureFormat::kPng);
    CHECK(picture_format("x.exr") == PictureFormat::kExr);
    CHECK(picture_format("x.hdr") == PictureFormat::kHdr);
    CHECK(picture_format("x.pfm") == PictureFormat::kPfm);
    CHECK(picture_format("x.bmp") == PictureFormat::kBmp);
    CHECK(picture_format("x.tga") == PictureFormat::kTga);
    CHECK_FALSE(picture_format("x.jpg"));
    CHECK_FALSE(picture_format("png"));
    CHECK_FALSE(picture_format(""));
}

TEST_CASE("8-bit formats give back every byte value, colour and grey, odd sizes") {
    for (const std::uint32_t channels : {1U, 3U}) {
        for (const auto& [width, height] : {std::pair{1U, 1U}, {3U, 5U}, {64U, 17U}, {257U, 4U}}) {
            Plane32 plane{width, height, channels, {}};
            std::uint32_t k = 0;
            for (std::size_t i = 0; i < std::size_t{width} * height * channels; ++i) {
                plane.values.push_back(static_cast<float>((k += 37) % 256) / 255.0F);
            }
            for (const PictureFormat format :
                 {PictureFormat::kPng, PictureFormat::kBmp, PictureFormat::kTga}) {
                CAPTURE(static_cast<int>(format));
                const Encoded encoded = encode(plane, format);
                REQUIRE(encoded.error.empty());
                CHECK(encoded.bytes == encode(plane, format).bytes);
                const Decoded decoded = decode(encoded.bytes);
                REQUIRE(decoded.error == "");
                CHECK(decoded.eight_bit);
                CHECK(decoded.display);
                CHECK(decoded.plane.width == width);
                CHECK(decoded.plane.height == height);
                CHECK(same_bits(decoded.plane.values, three_channels(plane).values));
            }
        }
    }
}

TEST_CASE("PFM and EXR keep every bit of every float") {
    for (const std::uint32_t channels : {1U, 3U}) {
        const Plane32 plane = awkward_floats(29, 35, channels);
        for (const PictureFormat format : {PictureFormat::kPfm, PictureFormat::kExr}) {
            const Encoded encoded = encode(plane, format);
            REQUIRE(encoded.error.empty());
            CHECK(encoded.bytes == encode(plane, format).bytes);
            const Decoded decoded = decode(encoded.bytes);
            REQUIRE(decoded.error == "");
            CHECK_FALSE(decoded.eight_bit);
            CHECK_FALSE(decoded.display);
            CHECK(same_bits(decoded.plane.values, three_channels(plane).values));
        }
    }
}

TEST_CASE("HDR keeps each pixel within half a step of its largest component") {
    const Plane32 plane = light(40, 9);
    const Decoded decoded = decode(encode(plane, PictureFormat::kHdr).bytes);
    REQUIRE(decoded.error == "");
    for (std::size_t i = 0; i < plane.values.size(); i += 3) {
        const float* p = &plane.values[i];
        const float largest = std::max(p[0], std::max(p[1], p[2]));
        for (std::size_t c = 0; c < 3; ++c) {
            // Mantissas have 8 bits and the largest is at least 128: half a step is 1/256 of it.
            CHECK(std::fabs(decoded.plane.values[i + c] - p[c]) <= largest / 256);
        }
    }
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const Plane32 odd{2, 1, 3, {nan, -1, 0, infinity, 255.0F / 256, 1e-30F}};
    const Decoded read = decode(encode(odd, PictureFormat::kHdr).bytes);
    REQUIRE(read.error == "");
    CHECK(read.plane.values == std::vector<float>{0, 0, 0, 0x1.fep126F, 0, 0});
}

TEST_CASE("HDR: run lengths as other programs write them") {
    // Both codes of the Radiance file format page, written by hand.
    const std::string head = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n";
    const std::string newer = {2, 2, 0,         8, char(136), char(128), 4,         1,        2,
                               3, 4, char(132), 0, char(136), 64,        char(136), char(129)};
    const Decoded a = decode(head + newer);
    REQUIRE(a.error == "");
    // 2^(129 - 136) = 1/128.
    CHECK(a.plane.at(0, 0, 0) == 1.0F);
    CHECK(a.plane.at(3, 0, 1) == 4.0F / 128);
    CHECK(a.plane.at(4, 0, 1) == 0.0F);
    CHECK(a.plane.at(7, 0, 2) == 0.5F);
    const std::string older = {char(128), 2, 3, char(129), 1, 1, 1, 7};
    const Decoded b = decode(head + older);
    REQUIRE(b.error == "");
    CHECK(b.plane.at(0, 0, 0) == 1.0F);
    CHECK(b.plane.at(7, 0, 2) == 3.0F / 128);
}

TEST_CASE("quantisation: rounding, truncation, and what lies outside") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const Plane32 plane{
        9, 1, 1, {0.0F, 0.5F, 1.0F, -3.0F, 7.0F, nan, infinity, -infinity, 254.6F / 255}};
    const auto bytes = [&plane](Quantise quantise) {
        std::vector<int> result;
        const Decoded read = decode(encode(plane, PictureFormat::kPng, {quantise, false}).bytes);
        for (std::uint32_t x = 0; x < plane.width; ++x) {
            result.push_back(static_cast<int>(read.plane.at(x, 0, 0) * 255.0F + 0.5F));
        }
        return result;
    };
    CHECK(bytes(Quantise::kRound) == std::vector<int>{0, 128, 255, 0, 255, 0, 255, 0, 255});
    CHECK(bytes(Quantise::kTruncate) == std::vector<int>{0, 127, 255, 0, 255, 0, 255, 0, 254});
}

TEST_CASE("sRGB: known pairs of IEC 61966-2-1") {
    // 0.5 -> 0.735357, 0.18 -> 0.461356, 0.002 -> 0.02584 (the straight part).
    const Plane32 plane{5, 1, 1, {0.0F, 0.002F, 0.18F, 0.5F, 1.0F}};
    const Decoded read = decode(encode(plane, PictureFormat::kPng, {Quantise::kRound, true}).bytes);
    CHECK(read.plane.at(0, 0, 0) * 255 == doctest::Approx(0));
    CHECK(read.plane.at(1, 0, 0) * 255 == doctest::Approx(7));
    CHECK(read.plane.at(2, 0, 0) * 255 == doctest::Approx(118));
    CHECK(read.plane.at(3, 0, 0) * 255 == doctest::Approx(188));
    CHECK(read.plane.at(4, 0, 0) * 255 == doctest::Approx(255));
}

TEST_CASE("sRGB: every byte comes back through the definition") {
    Plane32 plane{256, 1, 1, {}};
    for (int k = 0; k < 256; ++k) {
        const double display = k / 255.0;
        const double linear =
            display <= 0.04045 ? display / 12.92 : std::pow((display + 0.055) / 1.055, 2.4);
        plane.values.push_back(static_cast<float>(linear));
    }
    const Decoded read = decode(encode(plane, PictureFormat::kPng, {Quantise::kRound, true}).bytes);
    for (std::uint32_t k = 0; k < 256; ++k) {
        CHECK(read.plane.at(k, 0, 0) == static_cast<float>(k) / 255.0F);
    }
}

TEST_CASE("the first pixel is the top left one, and blue stays blue") {
    // Layouts from the formats' own definitions: BMP and TGA start at the bottom, blue first.
    const Plane32 plane{1, 2, 3, {1, 0, 0, 0, 0, 1}};  // red above blue
    const std::string bmp = encode(plane, PictureFormat::kBmp).bytes;
    REQUIRE(bmp.size() == 54 + 8);
    CHECK(bmp.substr(54) == std::string("\xff\0\0\0\0\0\xff\0", 8));
    const std::string tga = encode(plane, PictureFormat::kTga).bytes;
    REQUIRE(tga.size() == 18 + 6);
    CHECK(tga.substr(18) == std::string("\xff\0\0\0\0\xff", 6));
    const std::string pfm = encode(plane, PictureFormat::kPfm).bytes;
    CHECK(pfm.starts_with("PF\n1 2\n-1.0\n"));
    CHECK(pfm.substr(pfm.size() - 12, 4) == std::string("\0\0\x80\x3f", 4));  // red, last row
}

TEST_CASE("BMP: rows that run downwards have a negative height") {
    const Plane32 plane{1, 2, 3, {1, 0, 0, 0, 0, 1}};
    std::string file = encode(plane, PictureFormat::kBmp).bytes;
    file.replace(22, 4, "\xfe\xff\xff\xff");  // -2
    const Decoded decoded = decode(file);
    REQUIRE(decoded.error == "");
    CHECK(decoded.plane.height == 2);
    CHECK(decoded.plane.values == std::vector<float>{0, 0, 1, 1, 0, 0});
}

TEST_CASE("EXR: another reader sees the same numbers") {
    const Plane32 plane = light(33, 37);
    const Encoded encoded = encode(plane, PictureFormat::kExr);
    float* rgba = nullptr;
    int width = 0;
    int height = 0;
    const char* message = nullptr;
    const int status = LoadEXRFromMemory(
        &rgba, &width, &height, reinterpret_cast<const unsigned char*>(encoded.bytes.data()),
        encoded.bytes.size(), &message);
    REQUIRE(status == TINYEXR_SUCCESS);
    CHECK(width == 33);
    CHECK(height == 37);
    std::vector<float> values;
    for (std::size_t i = 0; i < std::size_t{33} * 37; ++i) {
        for (std::size_t c = 0; c < 3; ++c) values.push_back(rgba[i * 4 + c]);
    }
    std::free(rgba);
    CHECK(same_bits(values, plane.values));
}

TEST_CASE("EXR: another writer's half and float files, each compression that is read") {
    const Plane32 plane = halves(31, 35);
    for (const int compression : {TINYEXR_COMPRESSIONTYPE_NONE, TINYEXR_COMPRESSIONTYPE_RLE,
                                  TINYEXR_COMPRESSIONTYPE_ZIPS, TINYEXR_COMPRESSIONTYPE_ZIP}) {
        for (const int type : {TINYEXR_PIXELTYPE_HALF, TINYEXR_PIXELTYPE_FLOAT}) {
            CAPTURE(compression);
            CAPTURE(type);
            const Decoded decoded = decode(written_by_tinyexr(plane, compression, type));
            REQUIRE(decoded.error == "");
            CHECK(same_bits(decoded.plane.values, plane.values));
        }
    }
    const Decoded piz =
        decode(written_by_tinyexr(plane, TINYEXR_COMPRESSIONTYPE_PIZ, TINYEXR_PIXELTYPE_HALF));
    CHECK(piz.error == "EXR files are read uncompressed, run-length or ZIP compressed only");
}

TEST_CASE("JPEG is read, nearly") {
    Plane32 plane{32, 16, 3, {}};
    for (std::uint32_t i = 0; i < 32 * 16; ++i) {
        const float value = static_cast<float>(i % 32) / 32;
        plane.values.insert(plane.values.end(), {value, value, value});
    }
    const Decoded decoded = decode(written_as_jpeg(plane));
    REQUIRE(decoded.error == "");
    CHECK(decoded.eight_bit);
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        CHECK(std::fabs(decoded.plane.values[i] - plane.values[i]) < 4.0F / 255);
    }
}

TEST_CASE("what cannot be written is an error") {
    CHECK_FALSE(encode(Plane32{}, PictureFormat::kPng).error.empty());
    CHECK_FALSE(encode(Plane32{2, 2, 2, std::vector<float>(8)}, PictureFormat::kPng).error.empty());
    CHECK_FALSE(encode(Plane32{2, 2, 3, std::vector<float>(8)}, PictureFormat::kPng).error.empty());
    CHECK_FALSE(
        encode(Plane32{70000, 1, 1, std::vector<float>(70000)}, PictureFormat::kTga).error.empty());
}

TEST_CASE("a PNG of 16 bits keeps them all") {
    // One pixel, 0x0102 0x8000 0xffff.
    constexpr auto kFile = std::to_array<std::uint8_t>({
        0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44,
        0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x10, 0x02, 0x00, 0x00, 0x00, 0xc0,
        0xe7, 0x8f, 0x9d, 0x00, 0x00, 0x00, 0x12, 0x49, 0x44, 0x41, 0x54, 0x78, 0x01, 0x01, 0x07,
        0x00, 0xf8, 0xff, 0x00, 0x01, 0x02, 0x80, 0x00, 0xff, 0xff, 0x05, 0x14, 0x02, 0x82, 0x76,
        0x05, 0x9d, 0x18, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82,
    });
    const Decoded decoded = decode(std::string(kFile.begin(), kFile.end()));
    CAPTURE(decoded.error);
    REQUIRE(decoded.plane.values.size() == 3);
    CHECK(!decoded.eight_bit);
    CHECK(decoded.display);
    CHECK(decoded.plane.values[0] == 258.0F / 65535.0F);
    CHECK(decoded.plane.values[1] == 32768.0F / 65535.0F);
    CHECK(decoded.plane.values[2] == 1.0F);
}

}  // namespace
}  // namespace cobble::renderer
