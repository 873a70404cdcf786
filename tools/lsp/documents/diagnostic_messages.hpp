// SPDX-License-Identifier: MIT
// Findings as the protocol has them.
#pragma once

#include <map>
#include <string>

#include "tools/lsp/documents/workspace.hpp"

namespace cobble::lsp {

/// The document's findings by the URI of the file that each is about: scenes have findings in their
/// meshes too. The document itself is there even if it has none. `data` of each is what `cobble
/// lint
/// --format json` prints of it.
std::map<std::string, Json> diagnostics_by_file(Workspace& workspace, Document& document);

/// The edits of a fix that lie in the document, as a WorkspaceEdit; null if some lie elsewhere.
Json workspace_edit(const source::Fix& fix, const Document& document, source::SourceId source,
                    const TextPositions& positions);

}  // namespace cobble::lsp
