// SPDX-License-Identifier: MIT
// A scene through every phase up to the IR, its files all missing: nothing crashes, tokens and tree
// hold the whole text, and everything that is said lies inside it.
//
// What takes long is done to some inputs only, chosen by their bytes, so that the same input always
// takes the same way: fixes are verified in one of 64 (each costs one more check of the whole file)
// and the IR is written as JSON in one of 8.
#include <cstdint>
#include <string>
#include <string_view>

#include "frontend/check/check.hpp"
#include "frontend/check/verify_fixes.hpp"
#include "ir/hash.hpp"
#include "ir/json.hpp"
#include "ir/lower.hpp"
#include "tests/fuzz/expect.hpp"

namespace {

using namespace cobble;
using fuzz::expect;

/// Longer inputs reach nothing that shorter ones do not, and take time.
constexpr std::size_t kLargestInput = 4096;
constexpr std::uint32_t kVerifiedOneIn = 64;
constexpr std::uint32_t kJsonOneIn = 8;

/// FNV-1a.
std::uint32_t hash_of(std::string_view text) {
    std::uint32_t hash = 2166136261U;
    for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619U;
    return hash;
}

class NoFiles final : public source::FileSource {
  public:
    source::ReadResult read(std::string_view, std::uint64_t) override { return {}; }
    bool exists(std::string_view) override { return false; }
};

void expect_whole(const frontend::Tokens& tokens, const frontend::Cst& cst) {
    std::uint32_t end = 0;
    std::size_t comment = 0;
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        const frontend::ByteRange range = tokens.range({i});
        expect(range.begin >= end && range.end >= range.begin, "tokens are in order");
        end = range.end;
        while (comment < tokens.comments.size() && tokens.comments[comment].begin < range.begin) {
            expect(tokens.comments[comment].end <= range.begin, "comments stand between tokens");
            ++comment;
        }
    }
    expect(comment == tokens.comments.size(), "no comment stands inside a token");
    expect(end == tokens.text.size(), "the last token ends the text");
    expect(!cst.nodes.empty() && cst.nodes[0].end_token == tokens.size() &&
               cst.nodes[0].end_node == cst.nodes.size(),
           "the root holds all");
    for (std::uint32_t i = 1; i < cst.nodes.size(); ++i) {
        const frontend::CstNode& node = cst.nodes[i];
        expect(node.first_token < node.end_token && node.end_token <= tokens.size(),
               "a node has tokens");
        expect(node.end_node > i && node.end_node <= cst.nodes.size(), "a node ends after it");
        expect(node.first_token >= cst.nodes[i - 1].first_token, "nodes are in order");
    }
}

void expect_inside(const source::Span& span, const source::SourceMap& sources) {
    if (!span.valid()) return;
    expect(span.source.value < sources.size(), "a span has a source");
    expect(span.begin <= span.end, "a span runs forwards");
    if (span.source.value == 0) {
        expect(span.end <= sources.text(span.source).size(), "a span lies in its text");
    }
}

void expect_sound(const source::Diagnostic& diagnostic, const source::SourceMap& sources) {
    expect(diagnostic.code != nullptr && !diagnostic.message.empty(), "a finding says something");
    expect_inside(diagnostic.span, sources);
    for (const source::Related& related : diagnostic.related) expect_inside(related.span, sources);
    for (const source::Fix& fix : diagnostic.fixes) {
        for (const source::Edit& edit : fix.edits) expect_inside(edit.span, sources);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > kLargestInput) return -1;
    source::SourceMap sources;
    const source::SourceId id =
        sources.add("a.scene", std::string(reinterpret_cast<const char*>(data), size));
    const std::string_view text = sources.text(id);
    const std::uint32_t choice = hash_of(text);
    const frontend::CheckedScene checked = choice % kVerifiedOneIn == 0
                                               ? frontend::check(id, text)
                                               : frontend::check_unverified(id, text);
    expect_whole(checked.tokens, checked.cst);
    for (const source::Diagnostic& d : checked.diagnostics) expect_sound(d, sources);

    NoFiles files;
    const ir::Lowered lowered = ir::lower(checked, sources, files);
    for (const source::Diagnostic& d : lowered.diagnostics) expect_sound(d, sources);
    expect(ir::hash(lowered.scene).size() == 64, "a scene has a hash");
    if (choice % kJsonOneIn != 0) return 0;
    expect(ir::to_json(lowered.scene, sources).starts_with("{"), "a scene is JSON");
    return 0;
}
