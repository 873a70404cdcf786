// SPDX-License-Identifier: MIT
// The document that a request is about, as a scene, with its positions.
#pragma once

#include "frontend/lex/tokens.hpp"
#include "tools/lsp/documents/workspace.hpp"

namespace cobble::lsp {

struct AskedScene {
    /// Throws as Workspace::document_of() does, and RequestError if the document is no scene.
    AskedScene(Workspace& workspace, const Json& params)
        : document(workspace.document_of(params)),
          scene(scene_of(document)),
          text(document.text()),
          positions(workspace.positions_of(text)) {}

    [[nodiscard]] std::uint32_t offset(const Json& params) const {
        return positions.offset(params.at("position"));
    }
    [[nodiscard]] Json range(frontend::ByteRange bytes) const {
        return positions.range(bytes.begin, bytes.end);
    }

    Document& document;
    const frontend::CheckedScene& scene;
    std::string_view text;
    TextPositions positions;

  private:
    static const frontend::CheckedScene& scene_of(Document& document) {
        const frontend::CheckedScene* const scene = document.analysis().scene();
        if (scene == nullptr) throw RequestError(ErrorCode::kRequestFailed, "it is no scene");
        return *scene;
    }
};

}  // namespace cobble::lsp
