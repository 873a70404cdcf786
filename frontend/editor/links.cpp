// SPDX-License-Identifier: MIT
#include "frontend/editor/links.hpp"

#include <algorithm>

namespace cobble::frontend::editor {

PathKind path_kind(grammar::ValueType type) {
    switch (type) {
        case grammar::ValueType::kImagePath:
            return PathKind::kImage;
        case grammar::ValueType::kMeshPath:
            return PathKind::kMesh;
        case grammar::ValueType::kFolderPath:
            return PathKind::kFolder;
        default:
            return PathKind::kNone;
    }
}

std::vector<PathLink> links(const CheckedScene& scene, std::string_view) {
    std::vector<PathLink> result;
    for (const FieldNode& field : scene.ast.fields) {
        const PathKind kind = path_kind(grammar::row(field.row).type);
        if (kind == PathKind::kNone || field.broken || field.value_count != 1) continue;
        const TokenId token = scene.ast.values_of(field)[0].token;
        const std::string_view path = scene.tokens.word_of(token);
        if (path.empty()) continue;
        const std::uint32_t quote = scene.tokens.kind(token) == TokenKind::kString ? 1 : 0;
        const std::uint32_t begin = scene.tokens.range(token).begin + quote;
        result.push_back({{begin, begin + static_cast<std::uint32_t>(path.size())}, path, kind});
    }
    // Fields are stored where their block ends.
    std::ranges::sort(result, {}, [](const PathLink& link) { return link.span.begin; });
    return result;
}

}  // namespace cobble::frontend::editor
