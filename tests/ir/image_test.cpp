// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "ir/assets/transfer.hpp"
#include "ir/image/decoder.hpp"
#include "ir/image/integrity.hpp"
#include "tests/ir/image_files.hpp"
#include "tests/ir/support.hpp"

using namespace cobble;
using namespace cobble::image;
using namespace cobble::test;

namespace {

constexpr std::uint64_t kLimit = 1U << 20;
using Bytes = std::vector<std::uint8_t>;

image::Decoded decode(const std::string& file, std::uint64_t limit = kLimit) {
    return image::decode(file, {limit, false});
}

std::string reason(const std::string& file) {
    const auto decoded = decode(file);
    REQUIRE(decoded.status != Status::kOk);
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
        REQUIRE(decoded.status == Status::kOk);
        CHECK(decoded.width == 2);
        CHECK(decoded.height == 2);
        CHECK(decoded.bytes == expected);
        CHECK(find_damage(file).empty());
    }
}

TEST_CASE("grey becomes three channels and transparency is dropped") {
    const auto grey = decode(png(2, 1, 0, std::string("\0\x05\xfe", 3)));
    REQUIRE(grey.status == Status::kOk);
    CHECK(grey.bytes == Bytes{5, 5, 5, 254, 254, 254});
    const auto clear = decode(png(1, 1, 6, std::string("\0\x01\x02\x03\x00", 5)));
    REQUIRE(clear.status == Status::kOk);
    CHECK(clear.bytes == Bytes{1, 2, 3});
}

TEST_CASE("JPEG pictures are read, and missed if cut short") {
    const std::string file = jpeg(16, 16, 0x4080c0);
    const auto decoded = decode(file);
    CAPTURE(decoded.reason);
    REQUIRE(decoded.status == Status::kOk);
    CHECK(decoded.width == 16);
    CHECK(std::abs(decoded.bytes[0] - 0x40) <= 3);
    CHECK(std::abs(decoded.bytes[1] - 0x80) <= 3);
    CHECK(std::abs(decoded.bytes[2] - 0xc0) <= 3);
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
    CHECK(decode(noted).status == Status::kOk);
    for (const std::string mark : {"", "\xff", "\xff\xff\xff"}) {
        std::string damaged = file;
        damaged.insert(2, table);
        CHECK(reason(mark + damaged) == "a Huffman table has more than 256 symbols");
    }
    std::string between = file;
    between.insert(file.size() - 2, table);
    CHECK(reason(between) == "a Huffman table has more than 256 symbols");
    between.insert(file.size() - 2, "\xff");  // any number may stand before a mark's code
    CHECK(reason(between) == "a Huffman table has more than 256 symbols");
}

TEST_CASE("what stands inside a JPEG's segments is not taken for marks") {
    const std::string file = jpeg(16, 16, 0x4080c0);
    const std::string table = std::string("\xff\xc4\x00\x13\x00", 5) + std::string(16, '\xff');
    std::string remark = file;
    remark.insert(file.size() - 2, std::string("\xff\xfe\x00\x17", 4) + table);
    CHECK(decode(remark).status == Status::kOk);
    // The end mark of a preview is not that of the picture.
    std::string cut = file.substr(0, file.size() - 2);
    cut.insert(2, std::string("\xff\xe1\x00\x04\xff\xd9", 6));
    CHECK(reason(cut) == "the file ends too early");
    CHECK(decode(cut + "\xff\xd9").status == Status::kOk);
    // Nor is what follows it part of it.
    CHECK(decode(file + table).status == Status::kOk);
    const std::size_t scan = file.find("\xff\xda");
    REQUIRE(scan != std::string::npos);
    CHECK(reason(file.substr(0, scan) + "\xff\xd9") == "the file ends too early");
}

TEST_CASE("16 bits are kept if asked for") {
    std::string file = png(1, 1, 2, std::string("\0\x01\x02\x03\x04\xff\xfe", 7), 16);
    const auto words = image::decode(file, {kLimit, true});
    CAPTURE(words.reason);
    REQUIRE(words.status == Status::kOk);
    CHECK(words.bytes.empty());
    CHECK(words.words == std::vector<std::uint16_t>{0x0102, 0x0304, 0xfffe});
    const auto bytes = decode(file);
    REQUIRE(bytes.status == Status::kOk);
    CHECK(bytes.words.empty());
    CHECK(bytes.bytes == Bytes{1, 3, 255});
    CHECK(image::decode(png(1, 1, 2, std::string("\0\1\2\3", 4)), {kLimit, true}).bytes ==
          Bytes{1, 2, 3});
}

TEST_CASE("HDR pictures hold light") {
    // 8 x 1 pixels in run-length form: red mantissa 128, exponent 129 is 1.0.
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n";
    file += std::string("\x02\x02\x00\x08", 4);
    file += std::string("\x88\x80\x88\x40\x88\x00\x88\x81", 8);
    const auto decoded = decode(file);
    CAPTURE(decoded.reason);
    REQUIRE(decoded.status == Status::kOk);
    CHECK(decoded.bytes.empty());
    REQUIRE(decoded.floats.size() == 24);
    CHECK(decoded.floats[0] == 1.0F);
    CHECK(decoded.floats[1] == 0.5F);
    CHECK(reason(file.substr(0, file.size() - 1)) == "the file ends too early");
    // A run of length zero makes some decoders wait for ever.
    std::string stuck = file;
    stuck[stuck.size() - 8] = '\0';
    CHECK(reason(stuck) == "a run of pixels has no length");
    std::string tall = file;
    tall.replace(tall.find("-Y 1"), 4, "+Y 1");
    CHECK(reason(tall) == "its rows are not stored from the top");
    CHECK(reason(file.substr(0, 20)) == "the file ends too early");
}

TEST_CASE("HDR rows without run lengths, and with the older ones") {
    const std::string header = "#?RGBE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X ";
    const std::string pixel = "\x80\x40\x20\x81";
    const auto plain = decode(header + "2\n" + pixel + pixel);
    REQUIRE(plain.status == Status::kOk);
    CHECK(plain.floats == std::vector<float>{1, 0.5F, 0.25F, 1, 0.5F, 0.25F});
    // One pixel and 2 + 256 more of it.
    const auto repeated = decode(header + "259\n" + pixel + "\1\1\1\2\1\1\1\1");
    CAPTURE(repeated.reason);
    REQUIRE(repeated.status == Status::kOk);
    CHECK(repeated.floats[258 * 3 + 1] == 0.5F);
    CHECK(reason(header + "9\n" + pixel + "\1\1\1\x9") == "a run of pixels is longer than its row");
    CHECK(reason(header + "9\n\1\1\1\x8" + pixel) == "a run of pixels has no pixel before it");
    CHECK(reason(header + "2\n" + pixel) == "the file ends too early");
}

TEST_CASE("sizes are judged before memory is taken") {
    const auto huge = decode(bmp_header(100000, 100000, 24, 0));
    CHECK(huge.status == Status::kTooLarge);
    CHECK(huge.reason == "it claims 100000 x 100000 pixels, and the limit is 1048576 pixels");
    CHECK(decode(bmp_header(100000, 100000, 24, 0), std::uint64_t{1} << 28).status ==
          Status::kTooLarge);
    CHECK(decode(png(60000, 60000, 2, "")).status == Status::kTooLarge);
    CHECK(decode(bmp(64, 64, [](auto, auto) { return 0U; }), 4095).status == Status::kTooLarge);
    CHECK(decode(bmp(64, 64, [](auto, auto) { return 0U; }), 4096).status == Status::kOk);
}

TEST_CASE("a stream that unpacks to far more than its picture is stopped") {
    // One pixel, and a deflate stream of 300 MB of zeros.
    const auto decoded = decode(png_of_stream(1, 1, 2, deflate_zeros(300U << 20)));
    CHECK(decoded.status != Status::kOk);
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
        if (decoded.status == Status::kOk) {
            REQUIRE(decoded.bytes.size() + decoded.floats.size() ==
                    std::size_t{decoded.width} * decoded.height * 3);
        } else {
            REQUIRE(!decoded.reason.empty());
        }
    }
}

TEST_CASE("pictures become light by the curve of sRGB, once") {
    ir::Image image;
    image.bytes = {0, 128, 255};
    decode_to_linear(image);
    CHECK(image.tag == ir::ColorTag::kLinear);
    CHECK(image.bytes.empty());
    REQUIRE(image.floats.size() == 3);
    CHECK(image.floats[0] == 0.0F);
    CHECK(image.floats[1] == doctest::Approx(0.2158605).epsilon(1e-6));
    CHECK(image.floats[2] == 1.0F);
    const auto once = image.floats;
    decode_to_linear(image);
    CHECK(image.floats == once);
}
