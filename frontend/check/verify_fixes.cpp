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

/// `all` holds the sorted keys of the scene. True if the changed text has no finding but those,
/// `gone` among them no more.
bool works(const CheckedScene& scene, const std::vector<Key>& all, const Key& gone,
           const source::Fix& fix) {
    const auto text = apply(scene.tokens.text, scene.source, fix);
    if (!text) return false;
    const auto edits = sorted_edits(fix, scene.source);
    const CheckedScene changed = check_unverified(scene.source, *text);
    std::vector<Key> after = keys_of(changed);
    for (Key& key : after) key.begin = before(edits, key.begin);
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

void verify_fixes(CheckedScene& scene) {
    const std::size_t size = scene.tokens.text.size();
    std::size_t fixes = 0;
    std::vector<Key> all;
    for (source::Diagnostic& diagnostic : scene.diagnostics) {
        if (diagnostic.fixes.empty()) continue;
        if (all.empty()) all = keys_of(scene);
        const Key key{diagnostic.code, diagnostic.severity, diagnostic.span.begin};
        std::erase_if(diagnostic.fixes, [&](const source::Fix& fix) {
            ++fixes;
            const bool affordable = size <= kLargestVerifiedFile && fixes <= kMostVerifications &&
                                    fixes * size <= kMostVerifiedBytes;
            return !affordable || !works(scene, all, key, fix);
        });
    }
}

}  // namespace cobble::frontend
