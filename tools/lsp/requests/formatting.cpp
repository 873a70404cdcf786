// SPDX-License-Identifier: MIT
// textDocument/formatting, rangeFormatting, onTypeFormatting: edits of white space alone.
#include <algorithm>

#include "tools/lsp/requests/requests.hpp"

namespace cobble::lsp {
namespace {

/// Lines from 1; 0 and 0 for all.
Json edits_of(Workspace& workspace, const Document& document, std::uint32_t first,
              std::uint32_t last) {
    const TextPositions positions = workspace.positions_of(document.text());
    Json edits = Json::array();
    for (const frontend::SpaceEdit& edit :
         workspace.language_of(document.path()).format(document.text(), first, last)) {
        edits.push_back({{"range", positions.range(edit.begin, edit.end)}, {"newText", edit.text}});
    }
    return edits;
}

}  // namespace

Json format_document(Workspace& workspace, const Json& params) {
    return edits_of(workspace, workspace.document_of(params), 0, 0);
}

Json format_range(Workspace& workspace, const Json& params) {
    const Document& document = workspace.document_of(params);
    const TextPositions positions = workspace.positions_of(document.text());
    const Bytes bytes = positions.bytes(params.at("range"));
    const source::LineIndex& lines = positions.lines();
    const std::uint32_t first = lines.locate(bytes.begin).line;
    source::LineColumn end = lines.locate(bytes.end);
    // A selection of whole lines ends where the next one begins.
    if (end.column == 1 && end.line > first) --end.line;
    return edits_of(workspace, document, first, end.line);
}

/// After a `}` its line; after a new line the one before it.
Json format_on_type(Workspace& workspace, const Json& params) {
    const Document& document = workspace.document_of(params);
    const TextPositions positions = workspace.positions_of(document.text());
    const std::uint32_t line =
        positions.lines().locate(positions.offset(params.at("position"))).line;
    const bool new_line = params.at("ch").get_ref<const std::string&>() == "\n";
    // The line that was begun is left to the editor's indentation: nothing stands there yet.
    const std::uint32_t last = new_line ? std::max(line - 1, 1U) : line;
    return edits_of(workspace, document, last, last);
}

}  // namespace cobble::lsp
