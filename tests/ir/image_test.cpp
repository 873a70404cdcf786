// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "ir/assets/image_decoder.hpp"
#include "ir/assets/image_integrity.hpp"
#include "ir/assets/transfer.hpp"
#include "tests/ir/image_files.hpp"
#include "tests/ir/support.hpp"

using namespace cobble;
using namespace cobble::ir;
using namespace cobble::test;

namespace {

constexpr std::uint64_t kLimit = 1U << 20;
using Bytes = std::vector<std::uint8_t>;

DecodedImage decode(const std::string& file, std::uint64_t limit = kLimit) {
    return decode_image(file, limit);
}

std::string reason(const std::string& file) {
    const auto decoded = decode(file);
    REQUIRE(decoded.status != DecodeStatus::kOk);
    REQUIRE(!decoded.reason.empty());
    return decoded.reason;
}

}  // namespace

TEST_CASE("each format gives its pixels, rows from the top") {
    const Bytes expected{255, 0, 0, 0, 255, 0, 0, 0, 255, 10, 20, 30};
    for (const auto& entry : four_pixels()) {
        const std::string& file = entry.second;
        CAPTURE(entry.first);
        const auto decoded = decode(file);
        CAPTURE(decoded.reason);
        REQUIRE(decoded.status == DecodeStatus::kOk);
        CHECK(decoded.image.width == 2);
        CHECK(decoded.image.height == 2);
        CHECK(decoded.image.tag == ColorTag::kDisplay);
        CHECK(decoded.image.bytes == expected);
        CHECK(!decoded.image.constant);
        CHECK(find_damage(file).empty());
    }
}

TEST_CASE("grey becomes three channels and transparency is dropped") {
    const auto grey = decode(png(2, 1, 0, std::string("\0\x05\xfe", 3)));
    REQUIRE(grey.status == DecodeStatus::kOk);
    CHECK(grey.image.bytes == Bytes{5, 5, 5, 254, 254, 254});
    const auto clear = decode(png(1, 1, 6, std::string("\0\x01\x02\x03\x00", 5)));
    REQUIRE(clear.status == DecodeStatus::kOk);
    CHECK(clear.image.bytes == Bytes{1, 2, 3});
    CHECK(clear.image.constant);
}

TEST_CASE("JPEG pictures are read, and missed if cut short") {
    const std::string file = jpeg(16, 16, 0x4080c0);
    const auto decoded = decode(file);
    CAPTURE(decoded.reason);
    REQUIRE(decoded.status == DecodeStatus::kOk);
    CHECK(decoded.image.width == 16);
    CHECK(std::abs(decoded.image.bytes[0] - 0x40) <= 3);
    CHECK(std::abs(decoded.image.bytes[1] - 0x80) <= 3);
    CHECK(std::abs(decoded.image.bytes[2] - 0xc0) <= 3);
    CHECK(reason(file.substr(0, file.size() - 2)) == "the file ends too early");
    // Counts of symbols that would overflow the decoder's tables.
    std::string overfull = file;
    const std::size_t tables = overfull.find("\xff\xc4");
    REQUIRE(tables != std::string::npos);
    overfull.replace(tables + 5, 16, std::string(16, '\xff'));
    CHECK(reason(overfull) == "a Huffman table has more than 256 symbols");

    // What a camera notes may look like such a table; only a real one is refused.
    const std::string table = std::string("\xff\xc4\x00\x13\x00", 5) + std::string(16, '\xff');
    std::string noted = file;
    noted.insert(2, std::string("\xff\xe1\x00\x17", 4) + table);
    CHECK(decode(noted).status == DecodeStatus::kOk);
    for (const std::string mark : {"", "\xff", "\xff\xff\xff"}) {
        std::string damaged = file;
        damaged.insert(2, table);
        CHECK(reason(mark + damaged) == "a Huffman table has more than 256 symbols");
    }
    std::string between = file;
    between.insert(file.size() - 2, table);
    CHECK(reason(between) == "a Huffman table has more than 256 symbols");
}

TEST_CASE("HDR pictures hold light") {
    // 8 x 1 pixels in run-length form: red mantissa 128, exponent 129 is 1.0.
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n";
    file += std::string("\x02\x02\x00\x08", 4);
    file += std::string("\x88\x80\x88\x40\x88\x00\x88\x81", 8);
    const auto decoded = decode(file);
    CAPTURE(decoded.reason);
    REQUIRE(decoded.status == DecodeStatus::kOk);
    CHECK(decoded.image.tag == ColorTag::kLinear);
    CHECK(decoded.image.bytes.empty());
    REQUIRE(decoded.image.floats.size() == 24);
    CHECK(decoded.image.floats[0] == 1.0F);
    CHECK(decoded.image.floats[1] == 0.5F);
    CHECK(decoded.image.constant);
    CHECK(reason(file.substr(0, file.size() - 1)) == "the file ends too early");
    // A run of length zero makes some decoders wait for ever.
    std::string stuck = file;
    stuck[stuck.size() - 8] = '\0';
    CHECK(reason(stuck) == "a run of pixels has no length");
}

TEST_CASE("sizes are judged before memory is taken") {
    const auto huge = decode(bmp_header(100000, 100000, 24, 0));
    CHECK(huge.status == DecodeStatus::kTooLarge);
    CHECK(huge.reason == "it claims 100000 x 100000 pixels, and the limit is 1048576");
    CHECK(decode_image(bmp_header(100000, 100000, 24, 0), std::uint64_t{1} << 28).status ==
          DecodeStatus::kTooLarge);
    CHECK(decode(png(60000, 60000, 2, "")).status == DecodeStatus::kTooLarge);
    CHECK(decode(bmp(64, 64, [](auto, auto) { return 0U; }), 4095).status ==
          DecodeStatus::kTooLarge);
    CHECK(decode(bmp(64, 64, [](auto, auto) { return 0U; }), 4096).status == DecodeStatus::kOk);
}

TEST_CASE("a stream that unpacks to far more than its picture is stopped") {
    // One pixel, and a deflate stream of 300 MB of zeros.
    const auto decoded = decode(png_of_stream(1, 1, 2, deflate_zeros(300U << 20)));
    CHECK(decoded.status != DecodeStatus::kOk);
}

TEST_CASE("damaged files are told in plain words") {
    for (const auto& entry : four_pixels()) {
        const std::string& file = entry.second;
        CAPTURE(entry.first);
        const std::string cut = file.substr(0, file.size() - 3);
        CHECK(reason(cut) == "the file ends too early");
        reason(file.substr(0, 10));
    }
    CHECK(reason("") == "the file is empty");
    CHECK(reason("some text that is no picture at all") ==
          "it is no BMP, PNG, JPEG, TGA or HDR picture");
    std::string flipped = four_pixels()[1].second;
    flipped[flipped.size() - 20] = static_cast<char>(flipped[flipped.size() - 20] ^ 1);
    CHECK(reason(flipped) == "the checksum of its IDAT chunk does not match");
    std::string palette =
        bmp_header(2, 1, 8, 2) + std::string(8, 'a') + std::string("\0\x02\0\0", 4);
    CHECK(reason(palette) == "a pixel is beyond its palette");
    CHECK(reason("BM" + std::string(60, '\0')) == "it claims 0 bits a pixel");
    std::string odd = palette;
    odd[28] = 3;
    CHECK(reason(odd) == "it claims 3 bits a pixel");
    // A thousand million rows of nothing: told at once.
    std::string endless = palette;
    endless.replace(18, 8, std::string("\0\0\0\0\0\0\0\x40", 8));
    endless[30] = 9;  // of no kind that the decoder knows
    CHECK(reason(endless) == "it has no pixels");
    std::string runs = bmp_header(2, 1, 8, 2) + std::string(12, '\0');
    runs[30] = 1;  // run-length compression
    CHECK(reason(runs) == "it is of a kind of BMP that cannot be read");
}

TEST_CASE("no mutation of a picture crashes or hangs the decoder") {
    std::mt19937 random(5);
    auto files = four_pixels();
    files.emplace_back(
        "HDR", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n" + std::string(16, '\x80'));
    for (int round = 0; round < 20000; ++round) {
        std::string file = files[random() % files.size()].second;
        const auto count = 1 + random() % 4;
        for (unsigned i = 0; i < count && !file.empty(); ++i) {
            const std::size_t at = random() % file.size();
            if (random() % 8 == 0) {
                file.resize(at);
            } else {
                file[at] = static_cast<char>(random());
            }
        }
        const auto decoded = decode(file, 1U << 16);
        if (decoded.status == DecodeStatus::kOk) {
            REQUIRE(decoded.image.bytes.size() + decoded.image.floats.size() ==
                    std::size_t{decoded.image.width} * decoded.image.height * 3);
        } else {
            REQUIRE(!decoded.reason.empty());
        }
    }
}

TEST_CASE("sRGB is decoded by the standard's curve, once") {
    CHECK(srgb_to_linear(0.0) == 0.0);
    CHECK(srgb_to_linear(1.0) == 1.0);
    CHECK(srgb_to_linear(0.5) == doctest::Approx(0.21404114048223255).epsilon(1e-14));
    CHECK(srgb_to_linear(0.04) == doctest::Approx(0.04 / 12.92).epsilon(1e-15));
    Image image;
    image.bytes = {0, 128, 255};
    decode_to_linear(image);
    CHECK(image.tag == ColorTag::kLinear);
    CHECK(image.bytes.empty());
    REQUIRE(image.floats.size() == 3);
    CHECK(image.floats[1] == doctest::Approx(0.2158605).epsilon(1e-6));
    const auto once = image.floats;
    decode_to_linear(image);
    CHECK(image.floats == once);
}
