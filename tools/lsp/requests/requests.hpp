// SPDX-License-Identifier: MIT
// The requests that are answered at once: each takes the workspace and the message's `params`, and
// gives the result. They throw Json::exception where `params` are not what the protocol says, and
// RequestError where there is no answer; the server makes errors of both.
#pragma once

#include <string_view>

#include "tools/lsp/documents/workspace.hpp"

namespace cobble::lsp {

using Request = Json (*)(Workspace& workspace, const Json& params);

// By subject, one file each.
Json format_document(Workspace& workspace, const Json& params);
Json format_range(Workspace& workspace, const Json& params);
Json format_on_type(Workspace& workspace, const Json& params);
Json code_actions(Workspace& workspace, const Json& params);
Json pull_diagnostics(Workspace& workspace, const Json& params);
Json pull_workspace_diagnostics(Workspace& workspace, const Json& params);
Json document_symbols(Workspace& workspace, const Json& params);
Json folding_ranges(Workspace& workspace, const Json& params);
Json selection_ranges(Workspace& workspace, const Json& params);
Json hover(Workspace& workspace, const Json& params);
Json completion(Workspace& workspace, const Json& params);
Json signature_help(Workspace& workspace, const Json& params);
Json semantic_tokens(Workspace& workspace, const Json& params);
Json semantic_tokens_range(Workspace& workspace, const Json& params);
Json document_colors(Workspace& workspace, const Json& params);
Json color_presentations(Workspace& workspace, const Json& params);
Json definition(Workspace& workspace, const Json& params);
Json references(Workspace& workspace, const Json& params);
Json highlights(Workspace& workspace, const Json& params);
Json prepare_rename(Workspace& workspace, const Json& params);
Json rename(Workspace& workspace, const Json& params);
Json document_links(Workspace& workspace, const Json& params);
Json inlay_hints(Workspace& workspace, const Json& params);

/// The types and modifiers of semantic tokens, in the order of their numbers.
Json semantic_legend();

/// The one of this method, or null.
Request find_request(std::string_view method);

}  // namespace cobble::lsp
