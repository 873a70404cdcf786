// SPDX-License-Identifier: MIT
#include "frontend/check/verify_fixes.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

namespace cobble::frontend {
namespace {

/// What makes two findings, before and after a change, the same one: messages may differ, since
/// they may name what has changed. Places are those of the text before the change.
struct Key {
    const source::DiagnosticCode* code;
    source::Severity severity;
    std::uint32_t begin;

    friend bool operator<(const Key& a, const Key& b) {
        return std::tuple(a.begin, a.code->code, a.severity) <
               std::tuple(b.begin, b.code->code, b.severity);
    }
};

std::vector<source::Edit> sorted_edits(const source::Fix& fix, source::SourceId source) {
    std::vector<source::Edit> edits;
    std::ranges::copy_if(fix.edits, std::back_inserter(edits),
                         [source](const source::Edit& edit) { return edit.span.source == source; });
    std::ranges::stable_sort(edits, {}, [](const source::Edit& edit) { return edit.span.begin; });
    return edits;
}

/// Where `offset` of the changed text was before. Inserted text was where its edit begins.
std::uint32_t before(const std::vector<source::Edit>& edits, std::uint32_t offset) {
    std::int64_t shift = 0;  // of the changed text against the old one, so far
    for (const source::Edit& edit : edits) {
        const std::int64_t begin = edit.span.begin + shift;
        if (offset < begin) break;
        const auto size = static_cast<std::int64_t>(edit.text.size());
        if (offset < begin + size) return edit.span.begin;
        shift += size - (edit.span.end - edit.span.begin);
    }
    return static_cast<std::uint32_t>(offset - shift);
}

std::vector<Key> keys_of(const CheckedScene& scene) {
    std::vector<Key> keys;
    keys.reserve(scene.diagnostics.size());
    for (const source::Diagnostic& diagnostic : scene.diagnostics) {
        keys.push_back({diagnostic.code, diagnostic.severity, diagnostic.span.begin});
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

/// Where the byte at `offset` of the text before is in the changed text.
std::uint32_t after_edits(const std::vector<source::Edit>& edits, std::uint32_t offset) {
    std::int64_t shift = 0;
    for (const source::Edit& edit : edits) {
        if (edit.span.end > offset) break;
        shift += static_cast<std::int64_t>(edit.text.size()) - (edit.span.end - edit.span.begin);
    }
    return static_cast<std::uint32_t>(offset + shift);
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// True if the change lets one name be seen for what it evidently is.
bool reveals_name(const CheckedScene& scene, const source::Diagnostic& diagnostic,
                  const source::Fix& fix) {
    const std::string_view code = diagnostic.code->code;
    if (code == "invisible-character") return true;
    if (code != "unknown-name" || fix.edits.size() != 1) return false;
    const source::Edit& edit = fix.edits.front();
    const std::string_view old =
        scene.tokens.text.substr(edit.span.begin, edit.span.end - edit.span.begin);
    return std::ranges::equal(old, edit.text, {}, lower, lower);
}

/// `all` holds the sorted keys of the scene. True if the changed text has no finding but those and
/// what stands in a block that is newly read, and the diagnostic's no more.
bool works(const CheckedScene& scene, const std::vector<Key>& all,
           const source::Diagnostic& diagnostic, const source::Fix& fix) {
    const Key gone{diagnostic.code, diagnostic.severity, diagnostic.span.begin};
    const auto text = apply(scene.tokens.text, scene.source, fix);
    if (!text) return false;
    const auto edits = sorted_edits(fix, scene.source);
    const CheckedScene changed = check_unverified(scene.source, *text);
    const ByteRange read = newly_read(scene, diagnostic, fix, changed);
    std::vector<Key> after;
    for (Key key : keys_of(changed)) {
        const bool is_new = key.begin >= read.begin && key.begin < read.end;
        key.begin = before(edits, key.begin);
        const bool is_gone = !(key < gone) && !(gone < key);
        if (!is_new || is_gone) after.push_back(key);
    }
    std::sort(after.begin(), after.end());
    std::vector<Key> allowed = all;
    allowed.erase(std::lower_bound(allowed.begin(), allowed.end(), gone));
    return std::includes(allowed.begin(), allowed.end(), after.begin(), after.end());
}

}  // namespace

std::optional<std::string> apply(std::string_view text, source::SourceId source,
                                 const source::Fix& fix) {
    std::string result;
    std::size_t at = 0;
    for (const source::Edit& edit : sorted_edits(fix, source)) {
        if (edit.span.begin < at || edit.span.end < edit.span.begin ||
            edit.span.end > text.size()) {
            return std::nullopt;
        }
        result += text.substr(at, edit.span.begin - at);
        result += edit.text;
        at = edit.span.end;
    }
    result += text.substr(at);
    return result;
}

ByteRange newly_read(const CheckedScene& scene, const source::Diagnostic& diagnostic,
                     const source::Fix& fix, const CheckedScene& changed) {
    if (!reveals_name(scene, diagnostic, fix)) return {0, 0};
    // The first token that begins where the old one did, or behind the blank put there.
    const auto& old = scene.tokens.tokens;
    const auto behind = std::upper_bound(
        old.begin(), old.end(), diagnostic.span.begin,
        [](std::uint32_t offset, const Token& token) { return offset < token.begin; });
    if (behind == old.begin()) return {0, 0};
    const std::uint32_t place = after_edits(sorted_edits(fix, scene.source), (behind - 1)->begin);
    const auto& tokens = changed.tokens.tokens;
    const auto name = std::lower_bound(
        tokens.begin(), tokens.end(), place,
        [](const Token& token, std::uint32_t offset) { return token.begin < offset; });
    const auto index = static_cast<std::uint32_t>(name - tokens.begin());
    for (const CstNode& node : changed.cst.nodes) {
        if (static_cast<NodeKind>(node.kind) != NodeKind::kBlock || node.first_token != index) {
            continue;
        }
        return {name->begin, changed.tokens.range({node.end_token - 1}).end};
    }
    return {0, 0};
}

void verify_fixes(CheckedScene& scene) {
    const std::size_t size = scene.tokens.text.size();
    std::size_t fixes = 0;
    std::vector<Key> all;
    for (source::Diagnostic& diagnostic : scene.diagnostics) {
        if (diagnostic.fixes.empty()) continue;
        if (all.empty()) all = keys_of(scene);
        std::erase_if(diagnostic.fixes, [&](const source::Fix& fix) {
            ++fixes;
            const bool affordable = size <= kLargestVerifiedFile && fixes <= kMostVerifications &&
                                    fixes * size <= kMostVerifiedBytes;
            return !affordable || !works(scene, all, diagnostic, fix);
        });
    }
}

}  // namespace cobble::frontend
