// SPDX-License-Identifier: MIT
// textDocument/hover, completion and signatureHelp.
#include <fmt/core.h>

#include "frontend/editor/completion.hpp"
#include "frontend/editor/hover.hpp"
#include "tools/lsp/requests/asked_scene.hpp"
#include "tools/lsp/requests/requests.hpp"

namespace cobble::lsp {
namespace {

using frontend::editor::CompletionItem;
using frontend::editor::CompletionKind;

Json markdown(std::string text) { return {{"kind", "markdown"}, {"value", std::move(text)}}; }

// LSP's CompletionItemKind.
int kind_of(CompletionKind kind) {
    constexpr int kClass = 7, kProperty = 10, kValue = 12, kKeyword = 14, kReference = 18;
    switch (kind) {
        case CompletionKind::kBlock:
            return kClass;
        case CompletionKind::kField:
            return kProperty;
        case CompletionKind::kKeyword:
            return kKeyword;
        case CompletionKind::kMaterial:
            return kReference;
        case CompletionKind::kValue:
            break;
    }
    return kValue;
}

}  // namespace

Json hover(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    const auto found = frontend::editor::hover(asked.scene, asked.text, asked.offset(params));
    if (!found) return nullptr;
    std::string text = found->title;
    for (const std::string& paragraph : found->paragraphs) text += "\n\n" + paragraph;
    return {{"contents", markdown(std::move(text))}, {"range", asked.range(found->span)}};
}

Json completion(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    const auto found = frontend::editor::complete(asked.scene, asked.text, asked.offset(params));
    constexpr int kSnippet = 2;
    Json items = Json::array();
    for (const CompletionItem& item : found.items) {
        const bool snippet = workspace.client.takes_snippets && !item.snippet.empty();
        Json entry = {{"label", item.label},
                      {"kind", kind_of(item.kind)},
                      {"sortText", fmt::format("{:06}", item.rank)},
                      {"textEdit",
                       {{"range", asked.range(item.span)},
                        {"newText", snippet ? item.snippet : item.insert}}}};
        if (snippet) entry["insertTextFormat"] = kSnippet;
        if (!item.detail.empty()) entry["detail"] = item.detail;
        if (!item.documentation.empty()) entry["documentation"] = markdown(item.documentation);
        items.push_back(std::move(entry));
    }
    return {{"isIncomplete", false}, {"items", std::move(items)}};
}

Json signature_help(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    const auto found = frontend::editor::signature(asked.scene, asked.text, asked.offset(params));
    if (!found.found) return nullptr;
    // By name, as offsets into the label would be in units of the client's.
    Json parameters = Json::array();
    for (const std::string& component : found.components) {
        parameters.push_back({{"label", component}});
    }
    Json one = {{"label", found.label}, {"parameters", std::move(parameters)}};
    if (!found.documentation.empty()) one["documentation"] = markdown(found.documentation);
    return {{"signatures", Json::array({std::move(one)})},
            {"activeSignature", 0},
            {"activeParameter", found.active}};
}

}  // namespace cobble::lsp
