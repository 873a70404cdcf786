// SPDX-License-Identifier: MIT
// textDocument/diagnostic and workspace/diagnostic: findings for clients that ask for them.
#include <fmt/core.h>

#include <functional>

#include "tools/lsp/documents/diagnostic_messages.hpp"
#include "tools/lsp/requests/requests.hpp"

namespace cobble::lsp {
namespace {

/// The same findings have the same one.
std::string result_id(const Json& items) {
    return fmt::format("{:016x}", std::hash<std::string>{}(
                                      items.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

Json report(Json items, const Json& previous) {
    const std::string id = result_id(items);
    if (previous.is_string() && previous == id) return {{"kind", "unchanged"}, {"resultId", id}};
    return {{"kind", "full"}, {"resultId", id}, {"items", std::move(items)}};
}

}  // namespace

Json pull_diagnostics(Workspace& workspace, const Json& params) {
    Document& document = workspace.document_of(params);
    auto files = diagnostics_by_file(workspace, document);
    Json result =
        report(std::move(files[document.uri()]), params.value("previousResultId", Json()));
    files.erase(document.uri());
    for (auto& [uri, items] : files) {
        result["relatedDocuments"][uri] = report(std::move(items), nullptr);
    }
    return result;
}

/// Of the documents that are open: which files of a folder are scenes is `cobble lint`'s to find.
Json pull_workspace_diagnostics(Workspace& workspace, const Json& params) {
    Json previous = Json::object();
    if (const auto ids = params.find("previousResultIds"); ids != params.end()) {
        for (const Json& id : *ids) {
            previous[id.at("uri").get_ref<const std::string&>()] = id.at("value");
        }
    }
    Json items = Json::array();
    for (const auto& [uri, document] : workspace.files.documents()) {
        auto files = diagnostics_by_file(workspace, *document);
        Json item = report(std::move(files[uri]), previous.value(uri, Json()));
        item["uri"] = uri;
        item["version"] = document->version();
        items.push_back(std::move(item));
    }
    return {{"items", std::move(items)}};
}

}  // namespace cobble::lsp
