// SPDX-License-Identifier: MIT
// textDocument/documentSymbol, foldingRange and selectionRange.
#include "frontend/editor/outline.hpp"
#include "tools/lsp/requests/asked_scene.hpp"
#include "tools/lsp/requests/requests.hpp"

namespace cobble::lsp {
namespace {

using frontend::editor::OutlineItem;
using grammar::Role;

// LSP's SymbolKind, by what comes nearest.
int symbol_kind(Role role) {
    constexpr int kModule = 2, kNamespace = 3, kProperty = 7, kConstructor = 9, kConstant = 14,
                  kObject = 19, kEvent = 24, kOperator = 25;
    switch (role) {
        case Role::kCamera:
            return kConstructor;
        case Role::kSection:
            return kModule;
        case Role::kLight:
            return kEvent;
        case Role::kMaterial:
        case Role::kNoise:
            return kConstant;
        case Role::kGroup:
            return kNamespace;
        case Role::kMaterialIndex:
            return kProperty;
        case Role::kObject:
            return kObject;
        case Role::kTransform:
        case Role::kMove:
        case Role::kMotion:
            break;
    }
    return kOperator;
}

Json symbol_of(const AskedScene& asked, const OutlineItem& item) {
    Json symbol = {{"name", item.name},
                   {"kind", symbol_kind(item.role)},
                   {"range", asked.range(item.span)},
                   {"selectionRange", asked.range(item.name_span)}};
    if (!item.detail.empty()) symbol["detail"] = item.detail;
    return symbol;
}

}  // namespace

Json document_symbols(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    // Where the blocks that are open stand: no recursion, however deep they are.
    Json top = Json::array();
    std::vector<Json> open;
    const auto close = [&] {
        Json symbol = std::move(open.back());
        open.pop_back();
        (open.empty() ? top : open.back()["children"]).push_back(std::move(symbol));
    };
    // An answer is written and read with recursion: deeper blocks are told on this level.
    constexpr std::size_t kDeepest = 100;
    for (const OutlineItem& item : frontend::editor::outline(asked.scene, asked.text)) {
        while (open.size() > std::min<std::size_t>(item.depth, kDeepest)) close();
        open.push_back(symbol_of(asked, item));
    }
    while (!open.empty()) close();
    return top;
}

Json folding_ranges(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    Json ranges = Json::array();
    for (const frontend::editor::Fold& fold : frontend::editor::folds(asked.scene, asked.text)) {
        const Json range = asked.range(fold.span);
        Json entry = {{"startLine", range["start"]["line"]},
                      {"startCharacter", range["start"]["character"]},
                      {"endLine", range["end"]["line"]},
                      {"endCharacter", range["end"]["character"]}};
        if (fold.kind == frontend::editor::FoldKind::kComment) entry["kind"] = "comment";
        ranges.push_back(std::move(entry));
    }
    return ranges;
}

Json selection_ranges(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    // Each holds the next larger one.
    constexpr std::size_t kMost = 100;
    Json result = Json::array();
    for (const Json& position : params.at("positions")) {
        std::vector<frontend::ByteRange> ranges =
            frontend::editor::selections(asked.scene, asked.text, asked.positions.offset(position));
        if (ranges.size() > kMost) ranges.erase(ranges.begin() + kMost, ranges.end() - 1);
        Json selection;
        for (auto at = ranges.rbegin(); at != ranges.rend(); ++at) {
            Json inner = {{"range", asked.range(*at)}};
            if (!selection.is_null()) inner["parent"] = std::move(selection);
            selection = std::move(inner);
        }
        if (selection.is_null()) selection = {{"range", {{"start", position}, {"end", position}}}};
        result.push_back(std::move(selection));
    }
    return result;
}

}  // namespace cobble::lsp
