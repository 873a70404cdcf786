// SPDX-License-Identifier: MIT
// What the language demands beyond its grammar. Input: a bound AST. Output: diagnostics, and the
// answers that lowering needs. Invariant: reads no file but the scene; nothing is reported twice,
// and nothing that follows from something already reported.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "frontend/ast/ast.hpp"

namespace cobble::frontend {

/// One scene file through all phases of the front end. `text` must outlive it.
struct CheckedScene {
    source::SourceId source;
    Tokens tokens;
    Cst cst;
    Ast ast;
    /// Per AST block: the index of its material among the children of Materials for objects
    /// (Sphere, Plane, Triangle, TriangleMesh, Box), kNoMaterial for all others and for objects
    /// without a usable material.
    std::vector<std::uint32_t> material_of_block;
    /// Children of Materials in order, broken ones included (they keep their index).
    std::vector<BlockNodeId> materials;
    std::vector<source::Diagnostic> diagnostics;  ///< parse, then check; each in order of spans

    static constexpr std::uint32_t kNoMaterial = 0xffffffffU;
    [[nodiscard]] bool has_errors() const;
};

/// lex, parse, bind and check in one call.
CheckedScene check(source::SourceId source, std::string_view text);

}  // namespace cobble::frontend
