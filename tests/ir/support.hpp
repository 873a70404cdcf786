// SPDX-License-Identifier: MIT
// Files in memory, scenes from text, and small picture files, for the tests of this folder.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/source/file_source.hpp"
#include "ir/lower.hpp"

namespace cobble::test {

class MemoryFiles : public source::FileSource {
  public:
    std::map<std::string, std::string, std::less<>> files;
    std::map<std::string, int, std::less<>> reads;  ///< how often each path was read

    source::ReadResult read(std::string_view path, std::uint64_t max_bytes) override;
    bool exists(std::string_view path) override;
};

/// A scene text through all phases, with everything that the result refers to.
struct Built {
    std::unique_ptr<source::SourceMap> sources = std::make_unique<source::SourceMap>();
    frontend::CheckedScene checked;
    ir::Lowered lowered;

    [[nodiscard]] const ir::Scene& scene() const { return lowered.scene; }
    /// "code" of each asset diagnostic, in order.
    [[nodiscard]] std::vector<std::string> codes() const;
};

/// The scene's path is "scene/test.txt", so that assets are sought in "scene/".
Built build(std::string_view text, MemoryFiles& files, const ir::LowerOptions& options = {});

/// A whole scene around the objects of a Group: one camera, one light, `materials` (one plain
/// material if empty), and `MaterialIndex 0`.
std::string scene_of(std::string_view objects, std::string_view materials = {});

/// A 24-bit BMP; `pixel(x, y)` gives 0xrrggbb, rows from the top.
template <typename Pixel>
std::string bmp(std::uint32_t width, std::uint32_t height, Pixel&& pixel);

std::string bmp_header(std::uint32_t width, std::uint32_t height, std::uint32_t bits,
                       std::uint32_t palette);
std::string little(std::uint64_t value, int bytes);

template <typename Pixel>
std::string bmp(std::uint32_t width, std::uint32_t height, Pixel&& pixel) {
    std::string file = bmp_header(width, height, 24, 0);
    for (std::uint32_t row = height; row-- > 0;) {
        for (std::uint32_t x = 0; x < width; ++x) file += little(pixel(x, row), 3);
        file.append((4 - width * 3 % 4) % 4, '\0');
    }
    return file;
}

}  // namespace cobble::test
