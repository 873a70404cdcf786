// SPDX-License-Identifier: MIT
// textDocument/codeAction: the fixes of findings, and all safe ones at once.
#include <algorithm>
#include <string>
#include <string_view>

#include "tools/lsp/documents/diagnostic_messages.hpp"
#include "tools/lsp/requests/requests.hpp"

namespace cobble::lsp {
namespace {

constexpr std::string_view kQuickFix = "quickfix";
constexpr std::string_view kFixAll = "source.fixAll";

/// Whether the client asked for actions of this kind, or of all; kinds are paths with dots.
bool wanted(const Json& context, std::string_view kind) {
    const auto only = context.find("only");
    if (only == context.end() || !only->is_array()) return true;
    return std::any_of(only->begin(), only->end(), [kind](const Json& entry) {
        if (!entry.is_string()) return false;
        const auto& name = entry.get_ref<const std::string&>();
        return name.empty() || kind == name || (kind.starts_with(name) && kind[name.size()] == '.');
    });
}

/// What differs, from the first byte to the last, as one edit.
Json difference(std::string_view before, std::string_view after, const TextPositions& positions) {
    const auto [head, other] =
        std::mismatch(before.begin(), before.end(), after.begin(), after.end());
    std::size_t begin = static_cast<std::size_t>(head - before.begin());
    std::size_t end = before.size();
    std::size_t after_end = after.size();
    while (end > begin && after_end > begin && before[end - 1] == after[after_end - 1]) {
        --end;
        --after_end;
    }
    // Not in the middle of a character.
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
    while (begin > 0 && begin < before.size() && continues(before[begin])) --begin;
    while (end < before.size() && continues(before[end])) {
        ++end;
        ++after_end;
    }
    return {{"range",
             positions.range(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end))},
            {"newText", after.substr(begin, after_end - begin)}};
}

}  // namespace

Json code_actions(Workspace& workspace, const Json& params) {
    Document& document = workspace.document_of(params);
    const TextPositions positions = workspace.positions_of(document.text());
    const Bytes range = positions.bytes(params.at("range"));
    const Json context = params.value("context", Json::object());
    Analysis& analysis = document.analysis();
    Json actions = Json::array();
    bool any_safe = false;
    for (const source::Diagnostic& diagnostic : analysis.diagnostics(workspace.files)) {
        any_safe = any_safe || std::any_of(diagnostic.fixes.begin(), diagnostic.fixes.end(),
                                           [](const source::Fix& fix) { return fix.safe; });
        const source::Span span = diagnostic.span;
        const bool touched = span.valid() && span.source == analysis.source() &&
                             span.begin <= range.end && span.end >= range.begin;
        if (!touched || !wanted(context, kQuickFix)) continue;
        for (const source::Fix& fix : diagnostic.fixes) {
            Json edit = workspace_edit(fix, document, analysis.source(), positions);
            if (edit.is_null()) continue;
            Json action = {{"title", fix.title}, {"kind", kQuickFix}, {"edit", std::move(edit)}};
            if (fix.safe) action["isPreferred"] = true;
            actions.push_back(std::move(action));
        }
    }
    if (any_safe && wanted(context, kFixAll)) {
        const FixedText fixed = workspace.language_of(document.path())
                                    .fix_all(document.path(), document.text(), workspace.files);
        if (fixed.applied > 0) {
            const Json edits = Json::array({difference(document.text(), fixed.text, positions)});
            actions.push_back({{"title", "Fix all that can be fixed safely"},
                               {"kind", kFixAll},
                               {"edit", {{"changes", {{document.uri(), edits}}}}}});
        }
    }
    return actions;
}

}  // namespace cobble::lsp
