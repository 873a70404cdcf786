// SPDX-License-Identifier: MIT
// JSON-RPC 2.0 as language servers speak it: messages made, and the codes of errors.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace cobble::lsp {

using Json = nlohmann::ordered_json;

/// JSON-RPC 2.0, section 5.1, and the Language Server Protocol's own.
enum class ErrorCode : int {
    kParseError = -32700,
    kInvalidRequest = -32600,
    kMethodNotFound = -32601,
    kInvalidParams = -32602,
    kInternalError = -32603,
    kServerNotInitialized = -32002,
    kRequestFailed = -32803,
    kContentModified = -32801,
    kRequestCancelled = -32800,
};

inline Json response(const Json& id, Json result) {
    return {{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}};
}
inline Json error_response(const Json& id, ErrorCode code, std::string_view message) {
    return {{"jsonrpc", "2.0"},
            {"id", id},
            {"error", {{"code", static_cast<int>(code)}, {"message", message}}}};
}
inline Json notification(std::string_view method, Json params) {
    return {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
}

}  // namespace cobble::lsp
