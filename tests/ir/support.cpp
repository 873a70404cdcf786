// SPDX-License-Identifier: MIT
#include "tests/ir/support.hpp"

namespace cobble::test {

source::ReadResult MemoryFiles::read(std::string_view path, std::uint64_t max_bytes) {
    ++reads[std::string(path)];
    const auto found = files.find(path);
    if (found == files.end()) return {source::ReadStatus::kMissing, {}, "no such file"};
    if (found->second.size() > max_bytes) return {source::ReadStatus::kTooLarge, {}, {}};
    return {source::ReadStatus::kOk, found->second, {}};
}

bool MemoryFiles::exists(std::string_view path) { return files.find(path) != files.end(); }

std::vector<std::string> Built::codes() const {
    std::vector<std::string> result;
    for (const auto& diagnostic : lowered.diagnostics) result.emplace_back(diagnostic.code->code);
    return result;
}

Built build(std::string_view text, MemoryFiles& files, const ir::LowerOptions& options) {
    Built built;
    const auto id = built.sources->add("scene/test.txt", std::string(text));
    built.checked = frontend::check(id, built.sources->text(id));
    built.lowered = ir::lower(built.checked, *built.sources, files, options);
    return built;
}

std::string scene_of(std::string_view objects, std::string_view materials) {
    std::string text =
        "PerspectiveCamera { center 0 0 10 direction 0 0 -1 up 0 1 0 angle 30 }\n"
        "Lights { DirectionalLight { direction 0 -1 0 color 1 1 1 } }\n"
        "Materials { ";
    text += materials.empty() ? "Material { }" : materials;
    text += " }\nGroup {\nMaterialIndex 0\n";
    text += objects;
    text += "\n}\n";
    return text;
}

std::string little(std::uint64_t value, int bytes) {
    std::string result;
    for (int i = 0; i < bytes; ++i) result += static_cast<char>(value >> (8 * i) & 255);
    return result;
}

std::string bmp_header(std::uint32_t width, std::uint32_t height, std::uint32_t bits,
                       std::uint32_t palette) {
    const std::uint32_t offset = 54 + 4 * palette;
    return "BM" + little(0, 8) + little(offset, 4) + little(40, 4) + little(width, 4) +
           little(height, 4) + little(1, 2) + little(bits, 2) + little(0, 8) + little(0, 8) +
           little(palette, 4) + little(0, 4);
}

}  // namespace cobble::test
