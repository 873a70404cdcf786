// SPDX-License-Identifier: MIT
#include "tests/frontend/format_mutate.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/corpus.hpp"

namespace cobble::frontend::testing {
namespace {

namespace fs = std::filesystem;

// Pieces that mean something to the lexer, the parser or the formatter.
constexpr std::array<std::string_view, 46> kPieces = {
    "{",
    "}",
    " ",
    "\n",
    "\r\n",
    "\r",
    "\n\n\n",
    "\t",
    "\v\f",
    "\"",
    "\"a b\"",
    "//",
    " // note\n",
    "\n  // alone  \n",
    "// cobble-format off\n",
    "\n// cobble-format on\n",
    "#ffeedd",
    "#fff",
    "1",
    "-.5e3",
    "1.2.3",
    " 0 1 0 90 ",
    "inf",
    "1e999",
    "0.5f",
    "\xEF\xBB\xBF",
    "\xff",
    "caf\xC3\xA9",
    "Group {",
    "Sphere",
    "Sphere { center 0 0 0 radius 1 }",
    "Lights",
    "PointLight lamp {",
    "Materials",
    "PhongMaterial",
    "texture",
    "texture\n a.bmp",
    "MaterialIndex",
    "Rotate {",
    "Matrix4f { 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 }",
    "Transform {",
    "color",
    "angle",
    "Motion",
    "name",
    "}}}}",
};

bool is_white(char c) { return std::string_view(" \t\r\n\v\f").find(c) != std::string_view::npos; }

/// The run of characters of one sort (white or not) around `at`.
std::pair<std::size_t, std::size_t> run_at(const std::string& text, std::size_t at) {
    std::size_t begin = at;
    std::size_t end = at;
    const bool white = is_white(text[at]);
    while (begin > 0 && is_white(text[begin - 1]) == white) --begin;
    while (end < text.size() && is_white(text[end]) == white) ++end;
    return {begin, end};
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    std::string result;
    std::size_t at = 0;
    for (;;) {
        const std::size_t found = text.find(from, at);
        result.append(text, at, found == std::string::npos ? found : found - at);
        if (found == std::string::npos) break;
        result.append(to);
        at = found + from.size();
    }
    text = result;
}

void add_texts(const fs::path& folder, std::vector<fs::path>& paths) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) return;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path extension = entry.path().extension();
        if (extension == ".scene" || extension == ".txt") paths.push_back(entry.path());
    }
}

}  // namespace

void mutate(std::string& text, std::string_view other, Random& random) {
    const std::size_t at = random.below(text.size() + 1);
    switch (random.below(text.empty() ? 2 : 11)) {
        case 0:
        case 1:
            text.insert(at, kPieces[random.below(kPieces.size())]);
            break;
        case 2: {  // a piece of another scene
            const std::size_t begin = random.below(other.size() + 1);
            text.insert(at, other.substr(begin, random.below(200)));
            break;
        }
        case 3:  // one byte lost
            text.erase(random.below(text.size()), 1);
            break;
        case 4: {  // one word or one gap lost
            const auto [begin, end] = run_at(text, random.below(text.size()));
            text.erase(begin, end - begin);
            break;
        }
        case 5: {  // one word or one gap twice
            const auto [begin, end] = run_at(text, random.below(text.size()));
            text.insert(end, text.substr(begin, end - begin));
            break;
        }
        case 6:  // any byte
            text[random.below(text.size())] = static_cast<char>(random.below(256));
            break;
        case 7:  // the rest not typed yet
            text.resize(at);
            break;
        case 8: {  // a brace lost
            const std::size_t brace = text.find_first_of("{}", random.below(text.size()));
            if (brace != std::string::npos) text.erase(brace, 1);
            break;
        }
        case 9: {  // other line ends
            constexpr std::array<std::string_view, 4> kEnds = {"\r\n", "\r", " ", "\n\n"};
            replace_all(text, "\n", kEnds[random.below(kEnds.size())]);
            break;
        }
        default: {  // a line moved
            const std::size_t begin = text.find('\n', random.below(text.size()));
            if (begin == std::string::npos) break;
            const std::size_t end = std::min(text.find('\n', begin + 1), text.size());
            const std::string line = text.substr(begin, end - begin);
            text.erase(begin, end - begin);
            text.insert(random.below(text.size() + 1), line);
        }
    }
}

std::string damaged(const std::vector<std::string>& texts, Random& random) {
    std::string text = texts[random.below(texts.size())];
    const std::string& other = texts[random.below(texts.size())];
    do {
        mutate(text, other, random);
    } while (random.below(2) == 0);
    return text;
}

int wanted_runs(int usual) {
    const char* wanted = std::getenv("COBBLE_MUTATIONS");
    return wanted != nullptr ? std::atoi(wanted) : usual;
}

std::vector<std::string> scene_texts() {
    const fs::path root = COBBLE_ROOT;
    std::vector<fs::path> paths;
    add_texts(root / "scenes", paths);
    add_texts(root / "tests/frontend", paths);
    add_texts(test::corpus(), paths);
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> texts;
    for (const fs::path& path : paths) {
        std::ifstream file(path, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
    return texts;
}

}  // namespace cobble::frontend::testing
