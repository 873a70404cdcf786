// SPDX-License-Identifier: MIT
#include "frontend/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <tuple>
#include <utility>

#include "frontend/check/checks.hpp"
#include "frontend/check/verify_fixes.hpp"
#include "frontend/source/utf8.hpp"

namespace cobble::frontend {
namespace {

const source::DiagnosticCode kNotText{
    "not-text",
    source::Severity::kError,
    "the file is no text",
    "Scenes are UTF-8 text. A file with a zero byte near its front is a picture, a program or an "
    "archive, and one that begins with a byte-order mark of UTF-16 is text that other programs "
    "cannot read as it is. Nothing else is said about such a file.",
    "(a picture that was renamed to scene.txt)",
    "Check that this is the file you meant. Save text in UTF-16 as UTF-8."};

using BlockCheck = void (*)(CheckContext&, BlockNodeId);

// The small language of checks.def.
constexpr grammar::BlockMask all_blocks() { return ~grammar::BlockMask{0}; }
grammar::BlockMask lists() {
    grammar::BlockMask mask = 0;
    for (const grammar::BlockRow& row : grammar::blocks()) {
        if (row.layout == grammar::Layout::kList) mask |= grammar::mask_of(row.id);
    }
    return mask;
}

/// For each kind of block, the checks that look at it.
std::array<std::vector<BlockCheck>, grammar::kBlockCount> checks_by_block() {
    using enum grammar::BlockId;
    constexpr auto only = [](grammar::BlockId id) { return grammar::mask_of(id); };
    const std::pair<BlockCheck, grammar::BlockMask> all[] = {
#define COBBLE_BLOCK_CHECK(function, blocks) {function, blocks},
#include "frontend/check/checks.def"
    };
    std::array<std::vector<BlockCheck>, grammar::kBlockCount> table;
    for (const auto& [check, mask] : all) {
        for (std::size_t i = 0; i < grammar::kBlockCount; ++i) {
            if ((mask & only(static_cast<grammar::BlockId>(i))) != 0) table[i].push_back(check);
        }
    }
    return table;
}

bool stands_before(const source::Diagnostic& a, const source::Diagnostic& b) {
    const auto key = [](const source::Diagnostic& d) {
        return std::pair(d.span.begin, d.span.end);
    };
    return std::tuple(key(a), a.code->code) < std::tuple(key(b), b.code->code);
}

/// Says in the last finding of each severity how many more there were.
void note_dropped(CheckContext& context) {
    for (const auto& [severity, name] : {std::pair(source::Severity::kError, "errors"),
                                         std::pair(source::Severity::kWarning, "warnings")}) {
        if (context.count(severity) <= source::kMostFindings) continue;
        const auto is_one = [wanted = severity](const source::Diagnostic& diagnostic) {
            return diagnostic.severity == wanted;
        };
        const auto last = std::find_if(context.found.rbegin(), context.found.rend(), is_one);
        last->notes.push_back(fmt::format("{} more {} of the file are not listed",
                                          context.count(severity) - source::kMostFindings, name));
    }
}

}  // namespace

bool CheckedScene::has_errors() const {
    return std::ranges::any_of(diagnostics, [](const source::Diagnostic& diagnostic) {
        return diagnostic.severity == source::Severity::kError;
    });
}

CheckedScene check_unverified(source::SourceId source, std::string_view text) {
    static const auto table = checks_by_block();

    CheckedScene scene;
    scene.source = source;
    const bool binary = source::looks_binary(text);
    if (binary) {
        source::Diagnostic finding;
        finding.code = &kNotText;
        finding.severity = kNotText.severity;
        const bool utf16 = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
        finding.message = utf16 ? "the file is not text in UTF-8, but in UTF-16"
                                : "the file is not text: it holds zero bytes";
        scene.diagnostics.push_back(std::move(finding));
        // Whatever could be said about such bytes would only hide this.
        text = {};
    }
    scene.tokens = lex(text);
    scene.cst = parse(scene.tokens);
    BoundAst bound = bind(source, scene.tokens, scene.cst);
    scene.ast = std::move(bound.ast);
    if (binary) return scene;
    scene.diagnostics = std::move(bound.diagnostics);

    CheckContext context(scene);
    for (std::uint32_t i = 0; i < scene.ast.blocks.size(); ++i) {
        const BlockNode& block = scene.ast.blocks[i];
        if (block.broken) continue;
        for (const BlockCheck check : table[static_cast<std::size_t>(block.row)]) {
            check(context, BlockNodeId{i});
        }
    }
#define COBBLE_SCENE_CHECK(function) function(context);
#include "frontend/check/checks.def"

    note_dropped(context);
    std::ranges::stable_sort(context.found, stands_before);
    std::ranges::move(context.found, std::back_inserter(scene.diagnostics));
    return scene;
}

CheckedScene check(source::SourceId source, std::string_view text) {
    CheckedScene scene = check_unverified(source, text);
    verify_fixes(scene);
    return scene;
}

}  // namespace cobble::frontend
