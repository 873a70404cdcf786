// SPDX-License-Identifier: MIT
// Tokens after a field's name as the values that its row of the vocabulary asks for.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "frontend/ast/ast.hpp"
#include "frontend/ast/reporter.hpp"
#include "grammar/vocabulary.hpp"

namespace cobble::frontend {

/// Where a field's values stand, and how messages call it.
struct ValueRun {
    TokenId name;         ///< the field's or block's name: wrong counts are reported here
    std::uint32_t begin;  ///< tokens [begin, end)
    std::uint32_t end;
    std::string_view what;  ///< the name as messages quote it
    std::string hint = {};  ///< a note for a wrong count, if not empty
};

/// Binds one field, with a finding for each value that is wrong, or else one for their count. Cost:
/// the number of tokens.
FieldNode bind_values(const grammar::FieldRow& row, const ValueRun& run, NodeId cst, Ast& ast,
                      Reporter& reporter);

}  // namespace cobble::frontend
