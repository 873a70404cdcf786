// SPDX-License-Identifier: MIT
// Formatting a scene does not change what it means: the IR has the same hash, contents of textures
// and meshes included. COBBLE_MUTATIONS=N tries N damaged scenes in place of 1000.
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "frontend/format/format.hpp"
#include "ir/hash.hpp"
#include "ir/lower.hpp"
#include "tests/frontend/format_mutate.hpp"
#include "tests/ir/support.hpp"
#include "tests/support/disk.hpp"

namespace cobble::test {
namespace {

namespace fs = std::filesystem;

std::string hash_of(const fs::path& path, const std::string& text) {
    source::SourceMap sources;
    const source::SourceId id = sources.add(path.string(), text);
    const frontend::CheckedScene checked = frontend::check(id, sources.text(id));
    CHECK(!checked.has_errors());
    Disk files;
    return ir::hash(ir::lower(checked, sources, files).scene);
}

/// The same tokens on as few lines as comments allow: what formatting has to undo.
std::string squeezed(const std::string& text) {
    const frontend::Tokens tokens = frontend::lex(text);
    std::string result;
    std::size_t comment = 0;
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const frontend::ByteRange token = tokens.range({i});
        for (; comment < tokens.comments.size() && tokens.comments[comment].begin < token.begin;
             ++comment) {
            const frontend::ByteRange range = tokens.comments[comment];
            result.append("\n").append(text, range.begin, range.end - range.begin).append("\n");
        }
        result.append(" ").append(text, token.begin, token.end - token.begin);
    }
    return result;
}

TEST_CASE("a formatted scene has the hash of the scene") {
    int scenes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(COBBLE_ROOT) / "scenes")) {
        if (entry.path().extension() != ".scene") continue;
        ++scenes;
        CAPTURE(entry.path().string());
        const std::string text = file_text(entry.path());
        const std::string tight = squeezed(text);
        const std::string formatted = frontend::format(tight).text;
        CHECK(formatted != tight);
        const std::string hash = hash_of(entry.path(), text);
        CHECK(hash_of(entry.path(), tight) == hash);
        CHECK(hash_of(entry.path(), formatted) == hash);
    }
    CHECK(scenes >= 5);
}

TEST_CASE("a damaged scene that is still clean keeps its hash") {
    const auto texts = frontend::testing::scene_texts();
    const int runs = frontend::testing::wanted_runs(1000);
    int changed = 0;
    int clean = 0;
    for (int run = 0; run < runs; ++run) {
        frontend::testing::Random random = frontend::testing::random_of(run);
        const std::string text = frontend::testing::damaged(texts, random);
        const frontend::FormatResult formatted = frontend::format(text);
        changed += formatted.text != text;
        MemoryFiles none;
        const Built before = build(text, none);
        if (before.checked.has_errors()) continue;
        ++clean;
        const Built after = build(formatted.text, none);
        CAPTURE(run);
        CHECK(!after.checked.has_errors());
        CHECK(ir::hash(after.scene()) == ir::hash(before.scene()));
    }
    MESSAGE(runs << " damaged scenes made of " << texts.size() << ", " << changed
                 << " changed by formatting, " << clean
                 << " without errors, their hashes compared");
    CHECK(clean * 50 >= runs);
}

}  // namespace
}  // namespace cobble::test
