// SPDX-License-Identifier: MIT
#include "tools/lsp/server.hpp"

#include <fmt/core.h>

#include <utility>

#include "tools/lsp/documents/diagnostic_messages.hpp"
#include "tools/lsp/protocol/uri.hpp"
#include "tools/lsp/requests/requests.hpp"

namespace cobble::lsp {
namespace {

Json capabilities(const Client& client) {
    constexpr int kIncremental = 2;
    Json result = {
        {"positionEncoding", name_of(client.encoding)},
        {"textDocumentSync",
         {{"openClose", true}, {"change", kIncremental}, {"save", {{"includeText", false}}}}},
        {"documentFormattingProvider", true},
        {"documentRangeFormattingProvider", true},
        {"documentOnTypeFormattingProvider",
         {{"firstTriggerCharacter", "}"}, {"moreTriggerCharacter", Json::array({"\n"})}}},
        {"documentSymbolProvider", true},
        {"foldingRangeProvider", true},
        {"selectionRangeProvider", true},
        {"hoverProvider", true},
        {"completionProvider", Json::object()},
        {"signatureHelpProvider", {{"triggerCharacters", Json::array({" "})}}},
        {"semanticTokensProvider",
         {{"legend", semantic_legend()}, {"full", true}, {"range", true}}},
        {"colorProvider", true},
        {"definitionProvider", true},
        {"referencesProvider", true},
        {"documentHighlightProvider", true},
        {"renameProvider", {{"prepareProvider", true}}},
        {"documentLinkProvider", Json::object()},
        {"inlayHintProvider", true},
        {"codeActionProvider", {{"codeActionKinds", Json::array({"quickfix", "source.fixAll"})}}},
    };
    if (client.pulls_diagnostics) {
        result["diagnosticProvider"] = {{"identifier", "cobble"},
                                        {"interFileDependencies", true},
                                        {"workspaceDiagnostics", true}};
    }
    return result;
}

bool is_id(const Json& id) { return id.is_string() || id.is_number_integer(); }

}  // namespace

std::vector<Json> Server::handle_text(std::string_view body) {
    const Json message = Json::parse(body, nullptr, false);
    if (message.is_discarded()) {
        return {error_response(nullptr, ErrorCode::kParseError, "the message is no JSON")};
    }
    return handle(message);
}

std::vector<Json> Server::handle(const Json& message) {
    if (over()) return {};
    const auto invalid = [](const Json& id, std::string_view problem) {
        return std::vector<Json>{error_response(id, ErrorCode::kInvalidRequest, problem)};
    };
    if (!message.is_object()) return invalid(nullptr, "a message is an object");
    const auto id = message.find("id");
    const bool has_id = id != message.end();
    const auto method = message.find("method");
    if (method == message.end()) {
        // An answer to what the server asked, which it does not wait for; or nothing.
        const bool answers = message.contains("result") || message.contains("error");
        return answers ? std::vector<Json>{} : invalid(nullptr, "a message has a method");
    }
    if (has_id && !is_id(*id)) return invalid(nullptr, "an id is a string or an integer");
    if (!method->is_string()) return invalid(has_id ? *id : Json(), "a method is a string");
    const auto params = message.find("params");
    const Json empty = Json::object();
    const Json& given = params == message.end() || params->is_null() ? empty : *params;
    const auto& name = method->get_ref<const std::string&>();
    if (has_id) return {answer(name, *id, given)};
    try {
        notice(name, given);
    } catch (const Json::exception& problem) {
        // Nobody waits for an answer; a person may look for a reason.
        waiting_.push_back(
            notification("window/logMessage",
                         {{"type", 1}, {"message", fmt::format("{}: {}", name, problem.what())}}));
    }
    return {};
}

Json Server::answer(const std::string& method, const Json& id, const Json& params) {
    if (method == "initialize") {
        if (state_ != State::kNew) {
            return error_response(id, ErrorCode::kInvalidRequest, "initialize came before");
        }
    } else if (state_ == State::kNew) {
        return error_response(id, ErrorCode::kServerNotInitialized, "initialize comes first");
    } else if (state_ == State::kShutDown) {
        return error_response(id, ErrorCode::kInvalidRequest, "shutdown came before");
    }
    try {
        if (method == "initialize") return response(id, initialize(params));
        if (method == "shutdown") {
            state_ = State::kShutDown;
            return response(id, nullptr);
        }
        const Request request = find_request(method);
        if (request == nullptr) {
            return error_response(id, ErrorCode::kMethodNotFound, "there is no " + method);
        }
        return response(id, request(workspace_, params));
    } catch (const Json::exception& problem) {
        return error_response(id, ErrorCode::kInvalidParams, problem.what());
    } catch (const RequestError& problem) {
        return error_response(id, problem.code(), problem.what());
    }
}

Json Server::initialize(const Json& params) {
    const Json client = params.value("capabilities", Json::object());
    workspace_.client.encoding = choose_encoding(client);
    const Json documents = client.value("textDocument", Json::object());
    workspace_.client.pulls_diagnostics = documents.contains("diagnostic");
    workspace_.client.takes_snippets = documents.value("completion", Json::object())
                                           .value("completionItem", Json::object())
                                           .value("snippetSupport", false);
    state_ = State::kReady;
    return {{"capabilities", capabilities(workspace_.client)},
            {"serverInfo", {{"name", "cobble"}, {"version", COBBLE_VERSION}}}};
}

void Server::notice(const std::string& method, const Json& params) {
    if (method == "exit") {
        exit_code_ = state_ == State::kShutDown ? 0 : 1;
        state_ = State::kOver;
        return;
    }
    if (state_ != State::kReady) return;
    if (method == "textDocument/didOpen") return open(params);
    if (method == "textDocument/didClose") return close(params);
    if (method == "textDocument/didChange") {
        const Json& id = params.at("textDocument");
        Document* const document =
            workspace_.files.find(id.at("uri").get_ref<const std::string&>());
        if (document == nullptr) return;
        document->change(params.at("contentChanges"), id.value("version", std::int64_t{0}),
                         workspace_.client.encoding);
    }
    // What a scene names may have changed on the disk, or in another document.
    if (method == "workspace/didChangeWatchedFiles" || method == "textDocument/didSave") {
        for (const auto& [uri, document] : workspace_.files.documents()) {
            document->forget_analysis();
            document->dirty = true;
        }
    }
}

void Server::open(const Json& params) {
    const Json& item = params.at("textDocument");
    const auto& uri = item.at("uri").get_ref<const std::string&>();
    std::string path = path_of_uri(uri);
    const Language& language = workspace_.language_of(path);
    workspace_.files.open(std::make_unique<Document>(uri, std::move(path),
                                                     item.value("version", std::int64_t{0}),
                                                     item.at("text").get<std::string>(), language));
}

void Server::close(const Json& params) {
    const auto& uri = params.at("textDocument").at("uri").get_ref<const std::string&>();
    if (workspace_.files.find(uri) == nullptr) return;
    workspace_.files.close(uri);
    // Findings of a document that is not open are nobody's.
    std::vector<Json> messages;
    for (auto& [file, by_document] : told_) {
        if (by_document.contains(uri)) tell(file, uri, Json::array(), nullptr, messages);
    }
    for (Json& message : messages) waiting_.push_back(std::move(message));
}

bool Server::has_work() const {
    if (!waiting_.empty()) return true;
    if (state_ != State::kReady || workspace_.client.pulls_diagnostics) return false;
    for (const auto& [uri, document] : workspace_.files.documents()) {
        if (document->dirty) return true;
    }
    return false;
}

std::vector<Json> Server::work(Deadline /*deadline*/) {
    std::vector<Json> messages(std::make_move_iterator(waiting_.begin()),
                               std::make_move_iterator(waiting_.end()));
    waiting_.clear();
    if (!messages.empty() || !has_work()) return messages;
    for (const auto& [uri, document] : workspace_.files.documents()) {
        if (document->dirty) return publish(*document);
    }
    return messages;
}

std::vector<Json> Server::publish(Document& document) {
    document.dirty = false;
    auto files = diagnostics_by_file(workspace_, document);
    // Files that it had something to say about, and has not any more.
    for (const auto& [file, by_document] : told_) {
        if (by_document.contains(document.uri())) files.try_emplace(file, Json::array());
    }
    std::vector<Json> messages;
    for (auto& [file, items] : files) {
        const Json version = file == document.uri() ? Json(document.version()) : Json();
        tell(file, document.uri(), std::move(items), version, messages);
    }
    return messages;
}

void Server::tell(const std::string& uri, const std::string& of, Json items, const Json& version,
                  std::vector<Json>& messages) {
    auto& by_document = told_[uri];
    by_document[of] = std::move(items);
    Json all = Json::array();
    for (const auto& [document, found] : by_document) {
        for (const Json& item : found) all.push_back(item);
    }
    if (by_document[of].empty() && uri != of) by_document.erase(of);
    Json params = {{"uri", uri}, {"diagnostics", std::move(all)}};
    if (!version.is_null()) params["version"] = version;
    messages.push_back(notification("textDocument/publishDiagnostics", std::move(params)));
}

}  // namespace cobble::lsp
