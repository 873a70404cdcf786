// SPDX-License-Identifier: MIT
// textDocument/definition, references, documentHighlight, prepareRename and rename.
#include "frontend/editor/references.hpp"
#include "tools/lsp/requests/asked_scene.hpp"
#include "tools/lsp/requests/requests.hpp"

namespace cobble::lsp {

Json definition(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    const auto found = frontend::editor::definition(asked.scene, asked.text, asked.offset(params));
    if (!found) return nullptr;
    return {{"uri", asked.document.uri()}, {"range", asked.range(found->name_span)}};
}

Json references(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    const bool declaration =
        params.value("context", Json::object()).value("includeDeclaration", true);
    Json locations = Json::array();
    for (const auto& reference :
         frontend::editor::references(asked.scene, asked.text, asked.offset(params))) {
        if (reference.is_definition && !declaration) continue;
        locations.push_back(
            {{"uri", asked.document.uri()}, {"range", asked.range(reference.span)}});
    }
    return locations;
}

Json highlights(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    // LSP's DocumentHighlightKind.
    constexpr int kRead = 2, kWrite = 3;
    Json result = Json::array();
    for (const auto& reference :
         frontend::editor::references(asked.scene, asked.text, asked.offset(params))) {
        result.push_back({{"range", asked.range(reference.span)},
                          {"kind", reference.is_definition ? kWrite : kRead}});
    }
    return result;
}

Json prepare_rename(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    const auto target =
        frontend::editor::rename_target(asked.scene, asked.text, asked.offset(params));
    if (!target.refusal.empty()) throw RequestError(ErrorCode::kRequestFailed, target.refusal);
    return {{"range", asked.range(target.span)}, {"placeholder", target.current}};
}

Json rename(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    const auto& name = params.at("newName").get_ref<const std::string&>();
    const auto renamed =
        frontend::editor::rename(asked.scene, asked.text, asked.offset(params), name);
    if (!renamed.refusal.empty()) throw RequestError(ErrorCode::kRequestFailed, renamed.refusal);
    Json edits = Json::array();
    for (const auto& edit : renamed.edits) {
        edits.push_back({{"range", asked.range(edit.span)}, {"newText", edit.text}});
    }
    return {{"changes", {{asked.document.uri(), std::move(edits)}}}};
}

}  // namespace cobble::lsp
