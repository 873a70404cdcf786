// SPDX-License-Identifier: MIT
// No file makes the reader crash, hang, take memory on a lie, or accept what breaks off.
#include <doctest/doctest.h>
#include <tinyexr.h>

#include "renderer/picture/picture_io.hpp"
#include "tests/picture/sample.hpp"

namespace cobble::renderer {
namespace {

Plane32 ramp(std::uint32_t width, std::uint32_t height) {
    Plane32 plane{width, height, 3, {}};
    for (std::uint32_t i = 0; i < width * height * 3; ++i) {
        plane.values.push_back(static_cast<float>(i) / static_cast<float>(width * height * 3));
    }
    return plane;
}

std::vector<std::string> valid_files() {
    const Plane32 color = light(19, 11);
    std::vector<std::string> files;
    for (const PictureFormat format :
         {PictureFormat::kPng, PictureFormat::kBmp, PictureFormat::kTga, PictureFormat::kPfm,
          PictureFormat::kHdr, PictureFormat::kExr}) {
        files.push_back(encode(color, format).bytes);
    }
    for (const int compression : {TINYEXR_COMPRESSIONTYPE_NONE, TINYEXR_COMPRESSIONTYPE_RLE,
                                  TINYEXR_COMPRESSIONTYPE_ZIPS}) {
        files.push_back(written_by_tinyexr(halves(19, 11), compression, TINYEXR_PIXELTYPE_HALF));
    }
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n";
    for (int row = 0; row < 2; ++row) {
        hdr += {2, 2, 0, 8};
        for (int c = 0; c < 4; ++c) hdr += {4, char(130), 5, 6, 7, char(132), 9};
    }
    files.push_back(hdr);
    std::string tga = encode(color, PictureFormat::kTga).bytes.substr(0, 18);
    tga[2] = 10;  // run lengths
    for (int left = 19 * 11; left > 0; left -= 100) {
        tga += static_cast<char>(0x80 + (left < 100 ? left : 100) - 1);
        tga += "abc";
    }
    files.push_back(tga);
    files.push_back(written_as_jpeg(ramp(19, 11)));
    return files;
}

TEST_CASE("a picture that was read has the values that it claims") {
    for (const std::string& file : valid_files()) {
        const Decoded decoded = decode(file);
        CHECK(decoded.error == "");
        CHECK(decoded.plane.values.size() ==
              std::size_t{decoded.plane.width} * decoded.plane.height * 3);
    }
}

TEST_CASE("every file that breaks off is refused") {
    for (const std::string& file : valid_files()) {
        CAPTURE(file.substr(0, 4));
        // Some programs leave out what fills the last row of a BMP to four bytes.
        const std::size_t needed = file.starts_with("BM") ? file.size() - 19 % 4 : file.size();
        for (std::size_t size = 0; size < needed; ++size) {
            CAPTURE(size);
            const Decoded decoded = decode(std::string_view(file).substr(0, size));
            REQUIRE(decoded.error != "");
            REQUIRE(decoded.plane.values.empty());
        }
    }
}

TEST_CASE("changed bytes never crash the reader") {
    Random random(1);
    std::size_t refused = 0;
    for (const std::string& file : valid_files()) {
        for (int round = 0; round < 1500; ++round) {
            std::string changed = file;
            for (std::uint64_t n = 1 + random.below(6); n-- > 0;) {
                // Headers are where the sizes are: half of the changes go there.
                const std::size_t range = random.below(2) == 0 ? file.size() : 64;
                changed[random.below(range < file.size() ? range : file.size())] =
                    static_cast<char>(random.next() >> 32);
            }
            if (random.below(8) == 0) changed.resize(random.below(changed.size() + 1));
            const Decoded decoded = decode(changed, 1U << 20);
            refused += decoded.error.empty() ? 0 : 1;
            REQUIRE(decoded.plane.values.size() == std::size_t{decoded.plane.width} *
                                                       decoded.plane.height *
                                                       (decoded.plane.values.empty() ? 0 : 3));
        }
    }
    CHECK(refused > 1000);
}

TEST_CASE("a JPEG table with more symbols than there are") {
    std::string file = written_as_jpeg(ramp(19, 11));
    const std::size_t tables = file.find("\xff\xc4");
    REQUIRE(tables != std::string::npos);
    file.replace(tables + 5, 16, std::string(16, '\xff'));
    CHECK(decode(file).error == "a Huffman table has more than 256 symbols");
}

TEST_CASE("sizes that a file cannot hold are refused with a reason") {
    const std::string huge = "PF\n100000 100000\n-1.0\n";
    CHECK(decode(huge).error ==
          "it claims 100000 x 100000 pixels, and the limit is 178956970 pixels");
    CHECK(decode("PF\n8000 8000\n-1.0\n").error == "the PFM file breaks off before its last pixel");
    CHECK(decode("Pf\n1 1\n-0.0e1\n0000").error == "the PFM file's scale is 0");
    CHECK(decode("Pf\n1 1\n-.01\n0000").error.empty());
    CHECK(decode("PF\n0 8\n-1.0\n").error == "it has no pixels");
    CHECK(decode("PF\n-1 8\n-1.0\n").error == "it has no pixels");
    CHECK(decode("PF\n99999999999999999999 1\n-1.0\n").error == "it has no pixels");
    CHECK(decode("").error == "the file is empty");
    CHECK(decode("hello").error == "it is no PNG, BMP, TGA, JPEG, PFM, HDR or EXR picture");
    CHECK(decode("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8000 +X 8000\n").error ==
          "the file ends too early");
}

TEST_CASE("every size that can be written can be read, and no other side of the limit") {
    const auto header = [](std::uint32_t width, std::uint32_t height) {
        return "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
    };
    const auto within = [&](std::uint32_t width, std::uint32_t height) {
        const std::string error = decode(header(width, height)).error;
        CAPTURE(error);
        REQUIRE(error != "");
        return error == "the PFM file breaks off before its last pixel";
    };
    for (const std::uint32_t width : {1U, 2730U, 8193U, 13377U, 13378U, 20000U, 65535U}) {
        for (const std::uint32_t height : {1U, 2730U, 8193U, 13377U, 13378U, 20000U, 65535U}) {
            CAPTURE(width);
            CAPTURE(height);
            CHECK(within(width, height) == problem_of_size(width, height).empty());
        }
    }
    CHECK(within(13377, 13377));
    CHECK(!within(13378, 13378));
}

}  // namespace
}  // namespace cobble::renderer
