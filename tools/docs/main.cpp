// SPDX-License-Identifier: MIT
// cobble-docs [--check] [ROOT]: writes the generated pages under ROOT (default: this repository),
// or says which of those there differ from what it would write and exits with 1.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "frontend/source/diagnostic.hpp"
#include "tools/docs/pages.hpp"

namespace {

namespace fs = std::filesystem;

std::optional<std::string> read(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

/// Pictures of blocks that are no more; the folder holds nothing else.
std::vector<fs::path> leftovers(const fs::path& root,
                                const std::vector<cobble::docs::Page>& pages) {
    std::vector<fs::path> result;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(root / "grammar/railroad", error)) {
        const std::string path = "grammar/railroad/" + entry.path().filename().string();
        bool known = false;
        for (const auto& page : pages) known = known || page.path == path;
        if (!known) result.push_back(entry.path());
    }
    return result;
}

/// Two codes of one name would hide each other.
int count_repeated_codes() {
    const auto codes = cobble::source::all_codes();
    int repeated = 0;
    for (std::size_t i = 1; i < codes.size(); ++i) {
        if (codes[i]->code != codes[i - 1]->code) continue;
        ++repeated;
        fmt::print(stderr, "the diagnostic code {} is declared twice\n", codes[i]->code);
    }
    return repeated;
}

}  // namespace

int main(int argc, char** argv) {
    bool check = false;
    fs::path root = COBBLE_ROOT;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "--check") {
            check = true;
        } else {
            root = argv[i];
        }
    }
    if (count_repeated_codes() > 0) return 1;
    const auto examples = [](std::string_view name) {
        return read(fs::path(COBBLE_ROOT) / "tools/docs/examples" / (std::string(name) + ".scene"));
    };
    const auto pages = cobble::docs::all_pages(examples);
    int stale = 0;
    for (const auto& page : pages) {
        const fs::path path = root / page.path;
        if (read(path) == page.text) continue;
        ++stale;
        if (check) {
            fmt::print(stderr, "{} is not what cobble-docs writes\n", page.path);
            continue;
        }
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << page.text;
        fmt::print("wrote {}\n", page.path);
    }
    for (const fs::path& path : leftovers(root, pages)) {
        ++stale;
        if (check) {
            fmt::print(stderr, "{} is no longer written by cobble-docs\n", path.string());
        } else {
            fs::remove(path);
        }
    }
    if (check && stale > 0) {
        fmt::print(stderr, "write them anew: cmake --build BUILD --target docs\n");
        return 1;
    }
    return 0;
}
