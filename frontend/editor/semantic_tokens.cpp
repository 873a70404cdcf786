// SPDX-License-Identifier: MIT
#include "frontend/editor/semantic_tokens.hpp"

#include <iterator>

namespace cobble::frontend::editor {
namespace {

using grammar::BlockId;
using grammar::Role;
using grammar::ValueType;

static_assert(std::size(kSemanticTypeNames) ==
              static_cast<std::size_t>(SemanticType::kKeyword) + 1);

SemanticType type_of(Role role) {
    switch (role) {
        case Role::kCamera:
            return SemanticType::kCamera;
        case Role::kSection:
            return SemanticType::kSection;
        case Role::kLight:
            return SemanticType::kLight;
        case Role::kMaterial:
        case Role::kNoise:
        case Role::kMaterialIndex:
            return SemanticType::kMaterial;
        case Role::kGroup:
        case Role::kObject:
            return SemanticType::kObject;
        case Role::kTransform:
        case Role::kMove:
        case Role::kMotion:
            break;
    }
    return SemanticType::kTransform;
}

SemanticType type_of_word(ValueType type) {
    if (type == ValueType::kTextureFilter) return SemanticType::kKeyword;
    return type == ValueType::kMaterialRef ? SemanticType::kLabel : SemanticType::kPath;
}

struct Meaning {
    bool known = false;
    SemanticType type = SemanticType::kNumber;
    BlockId block = BlockId::kCount_;
};

/// What the tree says about each token.
std::vector<Meaning> meanings(const CheckedScene& scene) {
    const Tokens& tokens = scene.tokens;
    std::vector<Meaning> known(tokens.size());
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        // A number is one wherever it stands.
        const TokenKind kind = tokens.kind({i});
        if (kind == TokenKind::kNumber) known[i] = {true, SemanticType::kNumber, BlockId::kCount_};
        if (kind == TokenKind::kColor) known[i] = {true, SemanticType::kColor, BlockId::kCount_};
    }
    for (std::uint32_t i = 0; i < scene.ast.blocks.size(); ++i) {
        const BlockNode& block = scene.ast.blocks[i];
        const TokenId name{scene.cst.node(block.cst).first_token};
        for (const FieldNode& field : scene.ast.fields_of({i})) {
            const CstNode& node = scene.cst.node(field.cst);
            if (field.cst != block.cst && scene.cst.kind(field.cst) == NodeKind::kField) {
                known[node.first_token] = {true, SemanticType::kField, block.row};
            }
            // Of a broken field only the values that could be read are here.
            for (const Value& value : scene.ast.values_of(field)) {
                Meaning& meaning = known[value.token.value];
                meaning.block = block.row;
                if (meaning.known) continue;
                meaning.known = true;
                meaning.type = type_of_word(grammar::row(field.row).type);
            }
        }
        known[name.value] = {true, type_of(grammar::row(block.row).role), block.row};
        if (block.label.valid()) {
            known[block.label.value] = {true, SemanticType::kLabel, block.row};
        }
    }
    return known;
}

}  // namespace

std::vector<SemanticToken> semantic_tokens(const CheckedScene& scene, std::string_view) {
    const std::vector<Meaning> known = meanings(scene);
    std::vector<SemanticToken> result;
    result.reserve(known.size() + scene.tokens.comments.size());
    std::size_t comment = 0;
    const auto add_comments_before = [&scene, &result, &comment](std::uint32_t offset) {
        for (; comment < scene.tokens.comments.size(); ++comment) {
            const ByteRange range = scene.tokens.comments[comment];
            if (range.begin >= offset) return;
            result.push_back(
                {range.begin, range.end - range.begin, SemanticType::kComment, BlockId::kCount_});
        }
    };
    for (std::uint32_t i = 0; i < known.size(); ++i) {
        const ByteRange range = scene.tokens.range({i});
        add_comments_before(range.begin);
        if (!known[i].known) continue;
        result.push_back({range.begin, range.end - range.begin, known[i].type, known[i].block});
    }
    add_comments_before(0xffffffffU);
    return result;
}

}  // namespace cobble::frontend::editor
