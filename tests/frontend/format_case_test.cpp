// SPDX-License-Identifier: MIT
// Cases of the formatter: NAME.scene formats to NAME.formatted, both under tests/frontend/format.
// A first line `// range L1:L2` in NAME.scene asks for those lines only. COBBLE_UPDATE=1 rewrites
// the expectations; read them before committing.
#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "frontend/format/format.hpp"

namespace cobble::frontend {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

FormatOptions options_of(const std::string& text) {
    FormatOptions options;
    if (std::sscanf(text.c_str(), "// range %u:%u", &options.first_line, &options.last_line) != 2) {
        return {};
    }
    return options;
}

TEST_CASE("every case formats as it says") {
    const fs::path folder = fs::path(COBBLE_ROOT) / "tests/frontend/format";
    const char* update = std::getenv("COBBLE_UPDATE");
    int cases = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".scene") continue;
        ++cases;
        CAPTURE(entry.path().filename().string());
        fs::path expected = entry.path();
        expected.replace_extension(".formatted");
        const std::string text = read(entry.path());
        const FormatResult result = format(text, options_of(text));
        CHECK(!result.refused);
        CHECK(result.refusal == "");
        CHECK(!result.left_alone);
        const bool broken = entry.path().filename().string().starts_with("broken_");
        CHECK(result.has_errors == broken);
        if (update != nullptr && *update == '1') {
            std::ofstream(expected, std::ios::binary) << result.text;
        }
        CHECK(result.text == read(expected));
    }
    CHECK(cases >= 20);
}

TEST_CASE("indentation stops growing, so that nesting cannot make a file explode") {
    constexpr int kLevels = 200'000;
    std::string text;
    for (int i = 0; i < kLevels; ++i) text += "Group{";
    for (int i = 0; i < kLevels; ++i) text += "}";
    const FormatResult result = format(text);
    CHECK(!result.refused);
    CHECK(!result.left_alone);
    // A line has at most 80 columns of indentation, `Group {` and its end.
    CHECK(result.text.size() <= std::size_t{2} * kLevels * 88);
    CHECK(result.text.find("\n" + std::string(80, ' ') + "Group {\n") != std::string::npos);
    CHECK(result.text.find(std::string(81, ' ')) == std::string::npos);
}

TEST_CASE("nothing gives nothing") {
    CHECK(format("").text.empty());
    CHECK(format(" \r\n\t\n").text.empty());
    CHECK(format("\xEF\xBB\xBF").text == "\xEF\xBB\xBF");
    CHECK(format("\xEF\xBB\xBF \n").text == "\xEF\xBB\xBF");
}

TEST_CASE("line ends are those of the first line that is kept") {
    CHECK(format("Lights{}\nBackground{}\r\n").text == "Lights {}\nBackground {}\n");
    CHECK(format("Lights{}\r\nBackground{}\n").text == "Lights {}\r\nBackground {}\r\n");
    CHECK(format("Lights{}\rBackground{}\n").text == "Lights {}\rBackground {}\r");
    CHECK(format("\n\nLights{}\r\nBackground{}").text == "Lights {}\r\nBackground {}\r\n");
    CHECK(format("\r\nLights{}").text == "Lights {}\r\n");
}

TEST_CASE("bytes that would become a byte-order mark stay away from the start") {
    for (const std::string text : {" \xEF\xBB\xBF", "\n\xEF\xBB\xBF Lights {}", " \xEF\xBB\xBF{"}) {
        const FormatResult result = format(text);
        CHECK(!result.refused);
        CHECK(!result.text.starts_with("\xEF\xBB\xBF"));
    }
}

}  // namespace
}  // namespace cobble::frontend
