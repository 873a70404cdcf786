// SPDX-License-Identifier: MIT
// What all requests share: the open documents, the languages, and what the client can do.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "tools/lsp/documents/documents.hpp"
#include "tools/lsp/documents/language.hpp"
#include "tools/lsp/protocol/rpc.hpp"
#include "tools/lsp/protocol/text_positions.hpp"

namespace cobble::lsp {

/// Thrown by a request that has no answer; the client gets it as an error.
class RequestError : public std::runtime_error {
  public:
    RequestError(ErrorCode code, const std::string& message)
        : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ErrorCode code() const { return code_; }

  private:
    ErrorCode code_;
};

/// What the client said of itself.
struct Client {
    PositionEncoding encoding = PositionEncoding::kUtf16;
    bool takes_snippets = false;     ///< completions may have tab stops
    bool pulls_diagnostics = false;  ///< it asks for them, and they are not sent by themselves
};

struct Workspace {
    explicit Workspace(source::FileSource& disk) : files(disk), scenes(make_scene_language()) {}

    OpenFiles files;
    std::unique_ptr<Language> scenes;
    Client client;

    /// The language of a document; one for all until there is a second.
    [[nodiscard]] const Language& language_of(std::string_view /*path*/) const { return *scenes; }
    /// The document of `params.textDocument`, open or read from the disk for this one request.
    /// Throws RequestError if it is neither, and Json::exception if `params` names none.
    [[nodiscard]] Document& document_of(const Json& params);
    [[nodiscard]] TextPositions positions_of(std::string_view text) const {
        return {text, client.encoding};
    }

  private:
    std::unique_ptr<Document> read_;  ///< the last one that is not open
};

}  // namespace cobble::lsp
