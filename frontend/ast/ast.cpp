// SPDX-License-Identifier: MIT
#include "frontend/ast/ast.hpp"

namespace cobble::frontend {

const FieldNode* Ast::find(BlockNodeId id, grammar::FieldId row) const {
    const FieldNode* found = nullptr;
    for (const FieldNode& field : fields_of(id)) {
        if (field.row == row && !field.broken) found = &field;
    }
    return found;
}

}  // namespace cobble::frontend
