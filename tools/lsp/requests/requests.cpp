// SPDX-License-Identifier: MIT
#include "tools/lsp/requests/requests.hpp"

namespace cobble::lsp {

Request find_request(std::string_view method) {
    struct Row {
        std::string_view method;
        Request request;
    };
    static constexpr Row kRows[] = {
        {"textDocument/formatting", format_document},
        {"textDocument/rangeFormatting", format_range},
        {"textDocument/onTypeFormatting", format_on_type},
        {"textDocument/codeAction", code_actions},
        {"textDocument/diagnostic", pull_diagnostics},
        {"workspace/diagnostic", pull_workspace_diagnostics},
        {"textDocument/documentSymbol", document_symbols},
        {"textDocument/foldingRange", folding_ranges},
        {"textDocument/selectionRange", selection_ranges},
        {"textDocument/hover", hover},
        {"textDocument/completion", completion},
        {"textDocument/signatureHelp", signature_help},
        {"textDocument/semanticTokens/full", semantic_tokens},
        {"textDocument/semanticTokens/range", semantic_tokens_range},
        {"textDocument/documentColor", document_colors},
        {"textDocument/colorPresentation", color_presentations},
        {"textDocument/definition", definition},
        {"textDocument/references", references},
        {"textDocument/documentHighlight", highlights},
        {"textDocument/prepareRename", prepare_rename},
        {"textDocument/rename", rename},
        {"textDocument/documentLink", document_links},
        {"textDocument/inlayHint", inlay_hints},
    };
    for (const Row& row : kRows) {
        if (row.method == method) return row.request;
    }
    return nullptr;
}

}  // namespace cobble::lsp
