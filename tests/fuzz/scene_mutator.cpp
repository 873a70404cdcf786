// SPDX-License-Identifier: MIT
// libFuzzer's mutator, taught to write words of the language and whole pieces of scenes: half of
// the time it puts one in, the rest it leaves to libFuzzer.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "grammar/vocabulary.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max);

namespace {

std::vector<std::string> make_pieces() {
    std::vector<std::string> pieces = {
        "{",
        "}",
        "{}",
        "} }",
        "\n",
        "\r\n",
        "\r",
        "\n\n\n",
        "\t",
        "\"",
        "\"a b\"",
        "// note\n",
        "\n    // alone\n",
        "// cobble-format off\n",
        "// cobble-format on\n",
        "#ffeedd",
        "1",
        "-.5",
        "1e308",
        "1e999",
        "0 1 0",
        "0 1 0 90",
        "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
        "nan",
        "1.2.3",
        "0",
        "360000",
        "stone",
        "\xEF\xBB\xBF",
        "\xff",
        "Materials {\n  Material stone {}\n  Material {}\n}\n",
        "MaterialIndex 0\n",
        "Sphere {\n center 0 0 0\n radius 1\n}\n",
        "Transform {\n Translate 1 0 0\n Motion {\n Translate 2 0 0\n}\n",
        "PerspectiveCamera {\n center 0 0 10\n direction 0 0 -1\n up 0 1 0\n angle 30\n}\n"};
    for (const cobble::grammar::BlockRow& row : cobble::grammar::blocks()) {
        pieces.emplace_back(row.name);
        pieces.emplace_back(row.name).append(" {\n");
    }
    for (const cobble::grammar::FieldRow& row : cobble::grammar::fields()) {
        pieces.emplace_back(row.name).append(" ");
    }
    return pieces;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max, unsigned int seed) {
    static const std::vector<std::string> pieces = make_pieces();
    if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, max);
    seed /= 2;
    const std::string& piece = pieces[seed % pieces.size()];
    seed /= static_cast<unsigned>(pieces.size());
    if (size + piece.size() > max) return LLVMFuzzerMutate(data, size, max);
    const std::size_t at = seed % (size + 1);
    std::memmove(data + at + piece.size(), data + at, size - at);
    std::memcpy(data + at, piece.data(), piece.size());
    return size + piece.size();
}
