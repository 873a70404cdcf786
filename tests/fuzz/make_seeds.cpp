// SPDX-License-Identifier: MIT
// Writes the inputs that fuzzing starts from (tests/fuzz/corpus): the same bytes each time.
//
// Scenes are those of the examples and of the tests, meshes are written out here, pictures are
// encoded by the renderer; kinds of picture that it does not write are put together by hand.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "renderer/picture/picture_io.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace {

namespace fs = std::filesystem;
using namespace cobble;

const fs::path kRoot = COBBLE_ROOT;
const fs::path kCorpus = kRoot / "tests/fuzz/corpus";

void save(const std::string& kind, const std::string& name, const std::string& bytes) {
    fs::create_directories(kCorpus / kind);
    std::ofstream(kCorpus / kind / name, std::ios::binary) << bytes;
}

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Small scenes only: a fuzzer's speed is that of its inputs.
void scenes() {
    constexpr std::uintmax_t kMaxBytes = 1500;
    for (const char* folder :
         {"tools/docs/examples", "tests/frontend/format", "tests/frontend/cases"}) {
        for (const auto& entry : fs::directory_iterator(kRoot / folder)) {
            if (entry.path().extension() != ".scene" || entry.file_size() > kMaxBytes) continue;
            const std::string name = fmt::format("{}_{}", fs::path(folder).filename().string(),
                                                 entry.path().filename().string());
            const std::string text = read(entry.path());
            save("check", name, text);
            if (std::string(folder) != "tests/frontend/cases") save("format", name, text);
        }
    }
}

void meshes() {
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    save("obj", "triangle.obj", corners + "f 1 2 3\n");
    save("obj", "quad.obj", corners + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
    save("obj", "normals.obj", corners + "vn 0 0 1\nf 1//1 2//1 3//1\nf -4//-1 -2//-1 -1//-1");
    save("obj", "all.obj",
         "# note\r\nmtllib a.mtl\r\no thing\r\n" + corners +
             "vt .5 0.25 0\nvn 0 0 1e-3\ns 1\nusemtl b\nf 1/1/1 2/1/1 \\\n 3/1/1\nl 1 2\n");
    save("obj", "broken.obj", corners + "v 1e999 nan 0\nf 1 2\nf 0 9 -9\nf 1/ 2/x 3//\nvn 0 0\n");
}

renderer::Plane32 gradient(std::uint32_t width, std::uint32_t height, bool grey) {
    renderer::Plane32 plane;
    plane.width = width;
    plane.height = height;
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const float a = static_cast<float>(x) / static_cast<float>(width);
            const float b = static_cast<float>(y) / static_cast<float>(height);
            plane.values.insert(plane.values.end(), {a, grey ? a : b, grey ? a : 0.5F});
        }
    }
    return plane;
}

std::string little(std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xffU);
    return text;
}

/// A BMP of 4 x 2 pixels with 8 bits each and a palette of two colours.
std::string palette_bmp() {
    const std::string pixels("\0\1\0\1\1\0\1\0", 8);
    const std::string palette("\xff\0\0\0\0\xff\0\0", 8);
    const std::string info = little(40, 4) + little(4, 4) + little(2, 4) + little(1, 2) +
                             little(8, 2) + little(0, 4) + little(8, 4) + little(0, 8) +
                             little(2, 4) + little(0, 4);
    const std::uint32_t offset = 14 + 40 + 8;
    return "BM" + little(offset + 8, 4) + little(0, 4) + little(offset, 4) + info + palette +
           pixels;
}

/// A run-length coded TGA of 4 x 1 pixels: one run of three, one pixel as it is.
std::string run_length_tga() {
    return std::string("\0\0\x0a\0\0\0\0\0\0\0\0\0\4\0\1\0\x18\x20", 18) +
           std::string("\x82\x10\x20\x30\x00\x40\x50\x60", 8);
}

std::string jpeg() {
    std::string pixels;
    for (int i = 0; i < 16 * 8 * 3; ++i) pixels += static_cast<char>(i);
    std::string bytes;
    const auto append = [](void* to, void* data, int size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                              static_cast<std::size_t>(size));
    };
    stbi_write_jpg_to_func(append, &bytes, 16, 8, 3, pixels.data(), 50);
    return bytes;
}

void pictures() {
    struct Kind {
        const char* ending;
        renderer::PictureFormat format;
    };
    constexpr Kind kKinds[] = {
        {"png", renderer::PictureFormat::kPng}, {"bmp", renderer::PictureFormat::kBmp},
        {"tga", renderer::PictureFormat::kTga}, {"pfm", renderer::PictureFormat::kPfm},
        {"hdr", renderer::PictureFormat::kHdr}, {"exr", renderer::PictureFormat::kExr}};
    for (const Kind& kind : kKinds) {
        for (const bool grey : {false, true}) {
            const auto encoded = renderer::encode(gradient(9, 5, grey), kind.format);
            const std::string name = fmt::format("{}.{}", grey ? "grey" : "color", kind.ending);
            save("picture", name, encoded.bytes);
            const std::string ending = kind.ending;
            if (ending != "pfm" && ending != "exr") save("image", name, encoded.bytes);
        }
    }
    for (const char* folder : {"image", "picture"}) {
        save(folder, "palette.bmp", palette_bmp());
        save(folder, "color.jpg", jpeg());
        save(folder, "run_length.tga", run_length_tga());
    }
}

}  // namespace

int main() {
    fs::remove_all(kCorpus);
    scenes();
    meshes();
    pictures();
    return 0;
}
