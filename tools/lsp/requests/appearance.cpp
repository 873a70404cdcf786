// SPDX-License-Identifier: MIT
// textDocument/semanticTokens, documentColor, colorPresentation, documentLink and inlayHint.
#include "frontend/editor/colors.hpp"
#include "frontend/editor/inlay.hpp"
#include "frontend/editor/links.hpp"
#include "frontend/editor/semantic_tokens.hpp"
#include "grammar/vocabulary.hpp"
#include "tools/lsp/protocol/uri.hpp"
#include "tools/lsp/requests/asked_scene.hpp"
#include "tools/lsp/requests/requests.hpp"

namespace cobble::lsp {
namespace {

using frontend::editor::SemanticToken;

// A modifier for each block of the vocabulary, so that a theme can colour each on its own.
std::uint32_t modifiers_of(const SemanticToken& token) {
    static_assert(grammar::kBlockCount < 31, "they are the bits of a number that clients hold");
    const auto block = static_cast<std::uint32_t>(token.block);
    return block < grammar::kBlockCount ? 1U << block : 0U;
}

/// Five numbers a token, its place relative to the one before.
Json encoded(const AskedScene& asked, Bytes range) {
    Json data = Json::array();
    std::int64_t line = 0;
    std::int64_t character = 0;
    for (const SemanticToken& token : frontend::editor::semantic_tokens(asked.scene, asked.text)) {
        if (token.begin + token.length <= range.begin) continue;
        if (token.begin >= range.end) break;
        const Json at = asked.positions.range(token.begin, token.begin + token.length);
        const auto on_line = at["start"]["line"].get<std::int64_t>();
        const auto from = at["start"]["character"].get<std::int64_t>();
        const auto to = at["end"]["character"].get<std::int64_t>();
        data.push_back(on_line - line);
        data.push_back(on_line == line ? from - character : from);
        data.push_back(to - from);
        data.push_back(static_cast<int>(token.type));
        data.push_back(modifiers_of(token));
        line = on_line;
        character = from;
    }
    return {{"data", std::move(data)}};
}

}  // namespace

Json semantic_legend() {
    Json types = Json::array();
    for (const std::string_view name : frontend::editor::kSemanticTypeNames) types.push_back(name);
    Json modifiers = Json::array();
    for (const grammar::BlockRow& block : grammar::blocks()) modifiers.push_back(block.name);
    return {{"tokenTypes", std::move(types)}, {"tokenModifiers", std::move(modifiers)}};
}

Json semantic_tokens(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    return encoded(asked, {0, static_cast<std::uint32_t>(asked.text.size())});
}

Json semantic_tokens_range(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    return encoded(asked, asked.positions.bytes(params.at("range")));
}

Json document_colors(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    Json colors = Json::array();
    for (const auto& color : frontend::editor::colors(asked.scene, asked.text)) {
        colors.push_back(
            {{"range", asked.range(color.span)},
             {"color", {{"red", color.r}, {"green", color.g}, {"blue", color.b}, {"alpha", 1}}}});
    }
    return colors;
}

Json color_presentations(Workspace& /*workspace*/, const Json& params) {
    const Json& color = params.at("color");
    Json presentations = Json::array();
    for (const std::string& text : frontend::editor::color_presentations(
             color.at("red").get<double>(), color.at("green").get<double>(),
             color.at("blue").get<double>())) {
        presentations.push_back(
            {{"label", text}, {"textEdit", {{"range", params.at("range")}, {"newText", text}}}});
    }
    return presentations;
}

/// To files that are there: a link to nothing is a finding, not a link.
Json document_links(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    Json links = Json::array();
    for (const auto& link : frontend::editor::links(asked.scene, asked.text)) {
        const std::string path = source::resolve(asked.document.path(), link.path);
        if (!workspace.files.exists(path)) continue;
        links.push_back({{"range", asked.range(link.span)}, {"target", uri_of_path(path)}});
    }
    return links;
}

Json inlay_hints(Workspace& workspace, const Json& params) {
    const AskedScene asked(workspace, params);
    const Bytes range = asked.positions.bytes(params.at("range"));
    Json hints = Json::array();
    for (const auto& hint : frontend::editor::inlay_hints(asked.scene, asked.text)) {
        if (hint.offset < range.begin || hint.offset > range.end) continue;
        hints.push_back({{"position", asked.positions.position(hint.offset)},
                         {"label", hint.text},
                         {"paddingLeft", true}});
    }
    return hints;
}

}  // namespace cobble::lsp
