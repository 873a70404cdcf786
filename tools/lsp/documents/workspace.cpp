// SPDX-License-Identifier: MIT
#include "tools/lsp/documents/workspace.hpp"

#include <limits>
#include <utility>

#include "tools/lsp/protocol/uri.hpp"

namespace cobble::lsp {

Document& Workspace::document_of(const Json& params) {
    const auto& uri = params.at("textDocument").at("uri").get_ref<const std::string&>();
    if (Document* const open = files.find(uri)) return *open;
    const std::string path = path_of_uri(uri);
    source::ReadResult read = files.read(path, std::numeric_limits<std::uint32_t>::max() - 1);
    if (read.status != source::ReadStatus::kOk) {
        throw RequestError(ErrorCode::kRequestFailed, "cannot read " + path);
    }
    read_ = std::make_unique<Document>(uri, path, 0, std::move(read.bytes), language_of(path));
    return *read_;
}

}  // namespace cobble::lsp
