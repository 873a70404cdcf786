// SPDX-License-Identifier: MIT
#include "frontend/ast/ast.hpp"

#include <algorithm>

namespace cobble::frontend {

const FieldNode* Ast::find(BlockNodeId id, grammar::FieldId row) const {
    const FieldNode* found = nullptr;
    for (const FieldNode& field : fields_of(id)) {
        if (field.row == row && !field.broken) found = &field;
    }
    return found;
}

BlockNodeId Ast::block_of(NodeId cst) const {
    // Blocks stand in the order of their CST nodes.
    const auto found =
        std::lower_bound(blocks.begin(), blocks.end(), cst,
                         [](const BlockNode& node, NodeId wanted) { return node.cst < wanted; });
    if (found == blocks.end() || found->cst != cst) return {};
    return {static_cast<std::uint32_t>(found - blocks.begin())};
}

}  // namespace cobble::frontend
